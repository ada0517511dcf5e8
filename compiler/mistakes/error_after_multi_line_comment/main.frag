/* Several
   lines
   of text. */ out vec4 color;
void main() {
  /* one
     more */ color = vec4(missing);
}
