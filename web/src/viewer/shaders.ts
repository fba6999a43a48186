// SPDX-License-Identifier: MIT
/** The programs that draw the points: squares of pixels, cut to cells in a section and to spheres in space. */

export const pointVertices = `
attribute float value;
attribute float radius;
attribute float reach;
uniform float least, most;
uniform float pixelsOfMetre;
uniform bool logarithmic;
uniform vec2 limits;
varying float place;
varying float none;
varying float size;
varying float own;
varying vec2 middle;
void main() {
  none = radius < 0.0 ? 1.0 : 0.0;
  // Somewhat more than the cell's own radius: the outermost pixels must not be lost to rounding.
  size = min(abs(radius) + least, most);
  own = max(reach, least);
  middle = position.xy;
  float share = logarithmic ? log(max(value, 1e-30) / limits.x) / log(limits.y / limits.x)
    : (value - limits.x) / (limits.y - limits.x);
  place = none > 0.5 ? 0.0 : (clamp(share, 0.0, 1.0) * 255.0 + 0.5) / 256.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  gl_PointSize = 2.0 * size * pixelsOfMetre;
  if (radius == 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}`;

// In a section the depth is the distance from the point, so that every pixel belongs to the nearest one. Its opacity
// says whether it lies within half a size; the triangles of the cover add what lies between the points.
export const pointFragments = `
uniform sampler2D colours;
uniform float depthOfMetre;
uniform float longest;
uniform bool flatCells;
uniform vec3 walls;
varying float place;
varying float none;
varying float size;
varying float own;
varying vec2 middle;
void main() {
  vec2 corner = vec2(2.0, -2.0) * (gl_PointCoord - 0.5);
  float distance2 = dot(corner, corner);
  if (distance2 > 1.0) discard;
  vec3 colour = none > 0.5 ? vec3(0.6) : texture2D(colours, vec2(place, 0.5)).rgb;
  if (flatCells) {
    vec2 spot = middle + corner * size;
    if (spot.x < walls.x || spot.y < walls.y || spot.x > walls.z) discard;
    float distance = sqrt(distance2) * size;
    gl_FragDepth = distance / longest;
    gl_FragColor = vec4(colour, distance <= own ? 1.0 : 0.0);
    return;
  }
  float bulge = sqrt(1.0 - distance2);
  gl_FragDepth = gl_FragCoord.z - size * bulge * depthOfMetre;
  float light = max(dot(vec3(corner, bulge), vec3(-0.35, 0.5, 0.79)), 0.0);
  gl_FragColor = vec4(colour * (0.74 + 0.3 * light), 1.0);
}`;

export const plainVertices = `
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy, 0.0, 1.0); }`;
export const screenVertices = `
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;
export const plainFragments = `
void main() { gl_FragColor = vec4(1.0); }`;
