#ifndef A
#define A
float a;
