precision highp float;

out vec4 colour;

uniform vec3 groundColour;

void main() {
  colour = vec4(groundColour, 1.0);
}
