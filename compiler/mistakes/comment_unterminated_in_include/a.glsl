float a;
/* b
float b;
