#ifdef A
