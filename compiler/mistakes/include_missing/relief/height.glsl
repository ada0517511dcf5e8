float height() { return 1.0; }
