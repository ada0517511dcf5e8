uniform float turn;
