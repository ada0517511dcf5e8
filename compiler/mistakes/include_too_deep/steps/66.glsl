float bottom;
