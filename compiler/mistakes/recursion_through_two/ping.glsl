int pong(int n);
int ping(int n) { return pong(n - 1); }
int pong(int n) { return n < 0 ? 0 : ping(n); }
