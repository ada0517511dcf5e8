#define LEVELS 7
