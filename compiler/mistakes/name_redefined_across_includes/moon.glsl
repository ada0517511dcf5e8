
float light() { return 0.1; }
