float one() { return two; }
