float shade() { return 0.5; }
