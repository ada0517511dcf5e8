#ifndef QUALITY
#error "define QUALITY: 1, 2 or 3"
#endif
