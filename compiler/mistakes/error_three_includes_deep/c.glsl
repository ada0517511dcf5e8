


float deep() { return depth; }
