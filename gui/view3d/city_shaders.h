// GLSL of the city: a geometry pass that records what is where, and a picture pass that paints it.
#pragma once

namespace lodestone {

// Geometry pass: for each pixel the node (+1), and its normal with the metres above the node's base, packed.
inline constexpr const char* kGeometryVertexShader = R"(#version 150
in vec3 position;
in uint tag;
uniform mat4 clipFromMesh;
uniform vec3 meshFromEye;
out vec3 fromEye;
out float rise;
flat out uint node;
void main() {
  gl_Position = clipFromMesh * vec4(position, 1.0);
  fromEye = position + meshFromEye;
  rise = float(tag & 255u);
  node = (tag >> 8u) + 1u;
}
)";

inline constexpr const char* kGeometryFragmentShader = R"(#version 150
in vec3 fromEye;
in float rise;
flat in uint node;
uniform vec3 forward;
uniform int parallel;
out uvec2 outColour;
void main() {
  // Flat shading from the triangle itself: relative to the eye, so that floats have the digits where they are seen.
  vec3 normal = normalize(cross(dFdx(fromEye), dFdy(fromEye)));
  vec3 look = parallel != 0 ? forward : fromEye;
  if (dot(normal, look) > 0.0) normal = -normal;
  uvec3 n = uvec3(clamp(normal * 127.0 + 128.0, 0.0, 255.0));
  outColour = uvec2(node, n.x << 24u | n.y << 16u | n.z << 8u | uint(clamp(rise, 0.0, 255.0)));
}
)";

inline constexpr const char* kPictureVertexShader = R"(#version 150
in vec3 position;
out vec2 ndc;
void main() {
  ndc = position.xy;
  gl_Position = vec4(position.xy, 0.0, 1.0);
}
)";

// Picture pass: colours, light, ink lines and halos from the recorded pixels; sky and ground where there are
// none.
inline constexpr const char* kPictureFragmentShader = R"(#version 150
in vec2 ndc;
out vec4 outColour;
uniform vec2 corner;           // of the picture in the window, pixels
uniform vec2 jitter;           // shift of the picture plane, in half pictures
uniform usampler2D pixels;
uniform sampler2D depths;
uniform sampler2D nodeColours;
uniform int nodeColoursWidth, nodeColoursCount;
uniform vec2 nearFar;
uniform int parallel;
uniform vec3 rayOriginX, rayOriginY, rayForward, rayX, rayY;
uniform float eyeHeight;       // above the ground, metres
uniform vec2 eyePlan;          // eye relative to the grid's origin, wrapped to a whole number of cells
uniform vec3 sun;              // towards the light
uniform vec3 skyTop, skyHorizon, groundColour, gridColour, ink, selectedLine, hoverLine;
uniform float hazeDistance;    // metres at which haze has taken two thirds
uniform float gridStep;        // metres; 0: no grid
uniform int showGround;
uniform float edgeStrength;
uniform float pixelRatio;
uniform float buildingOpacity, contextOpacity;

vec3 rayDirection() { return rayForward + (ndc.x + jitter.x) * rayX + (ndc.y + jitter.y) * rayY; }

float metres(float depth) {
  if (parallel != 0) return mix(nearFar.x, nearFar.y, depth);
  return nearFar.x * nearFar.y / (nearFar.y - depth * (nearFar.y - nearFar.x));
}

vec4 colourOf(uint node) {
  // The context node has no entry of its own: it takes the last one, after all others.
  int i = min(int(node) - 1, nodeColoursCount - 1);
  return texelFetch(nodeColours, ivec2(i % nodeColoursWidth, i / nodeColoursWidth), 0);
}

// Anti-aliased lines of a square grid.
float grid(vec2 plan, float step) {
  vec2 cell = plan / step;
  vec2 width = fwidth(cell);
  vec2 off = abs(fract(cell - 0.5) - 0.5) / max(width, vec2(1e-6));
  float line = 1.0 - min(min(off.x, off.y), 1.0);
  return line * (1.0 - smoothstep(0.15, 0.45, max(width.x, width.y)));
}

vec3 sky(vec3 direction) {
  return mix(skyHorizon, skyTop, pow(clamp(direction.z, 0.0, 1.0), 0.55));
}

// Colour behind all buildings, and how far away that is.
vec3 backdrop(out float away) {
  vec3 direction = normalize(rayDirection());
  vec3 origin = (ndc.x + jitter.x) * rayOriginX + (ndc.y + jitter.y) * rayOriginY;
  away = 1e9;
  bool down = direction.z < -1e-5 && eyeHeight > 0.0 && showGround != 0;
  float t = down ? (eyeHeight + origin.z) / -direction.z : 1e9;
  vec2 plan = (origin + direction * min(t, 1e7)).xy + eyePlan;
  float lines = gridStep > 0.0 ? max(0.55 * grid(plan, gridStep), grid(plan, gridStep * 10.0)) : 0.0;
  if (!down) return sky(direction);
  away = t;
  float haze = parallel != 0 ? 0.0 : 1.0 - exp(-t / hazeDistance * 0.7);
  vec3 colour = mix(groundColour, gridColour, lines * 0.6);
  return mix(colour, skyHorizon, haze);
}

vec3 normalOf(uint bits) {
  return (vec3(bits >> 24u, (bits >> 16u) & 255u, (bits >> 8u) & 255u) - 128.0) / 127.0;
}

// A building's pixel without lines.
vec3 lit(uvec2 pixel, float away) {
  vec3 colour = colourOf(pixel.x).rgb;
  vec3 normal = normalOf(pixel.y);
  float direct = max(dot(normal, sun), 0.0);
  float open = 0.5 + 0.5 * normal.z;                       // how much sky a face sees
  float foot = smoothstep(0.0, 14.0, float(pixel.y & 255u));
  float wall = 1.0 - abs(normal.z);
  float light = (0.52 + 0.15 * open + 0.38 * direct) * mix(1.0, mix(0.82, 1.0, foot), wall);
  vec3 cool = vec3(0.93, 0.97, 1.06), warm = vec3(1.03, 1.0, 0.95);
  colour *= light * mix(cool, warm, clamp(direct * 1.4, 0.0, 1.0));
  float haze = parallel != 0 ? 0.0 : 0.55 * (1.0 - exp(-away / hazeDistance * 0.7));
  return mix(colour, skyHorizon, haze);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy - corner);
  ivec2 last = textureSize(pixels, 0) - 1;
  uvec2 p = texelFetch(pixels, at, 0).xy;
  float depth = texelFetch(depths, at, 0).r;
  float away;
  vec3 behind = backdrop(away);
  gl_FragDepth = depth;
  vec3 colour = behind;
  float near = away;
  if (p.x != 0u) {
    near = metres(depth);
    colour = lit(p, near);
  }

  // Ink: a thin line where the node or the face changes, drawn on the nearer side only.
  int reach = max(int(pixelRatio + 0.5), 1);
  ivec2 steps[4] = ivec2[4](ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1));
  float line = 0.0, shade = 0.0, marked = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 q = clamp(at + steps[i] * reach, ivec2(0), last);
    uvec2 o = texelFetch(pixels, q, 0).xy;
    float d = o.x == 0u ? away : metres(texelFetch(depths, q, 0).r);
    if (o.x != p.x) {
      if (near <= d) line = max(line, 1.0);
      if (o.x != 0u) marked = max(marked, colourOf(o.x).a);
      if (p.x != 0u) marked = max(marked, colourOf(p.x).a);
    } else if (p.x != 0u) {
      float bend = 1.0 - dot(normalOf(o.y), normalOf(p.y));
      line = max(line, 0.55 * smoothstep(0.06, 0.3, bend));
      line = max(line, 0.8 * smoothstep(0.02, 0.04, (d - near) / near));
    }
    // Halo: what lies behind something nearer is a little darker around it.
    ivec2 far = clamp(at + steps[i] * reach * 3, ivec2(0), last);
    uint other = texelFetch(pixels, far, 0).x;
    if (other != 0u && other != p.x) {
      float f = metres(texelFetch(depths, far, 0).r);
      shade += clamp((near - f) / (0.02 * near), 0.0, 1.0) * 0.25;
    }
  }
  float fade = parallel != 0 ? 1.0 : exp(-near / hazeDistance * 0.8);
  if (p.x != 0u || away < 1e8) colour *= 1.0 - 0.22 * shade * fade;
  colour = mix(colour, ink, line * edgeStrength * fade);
  // Opacity is that of a whole layer: the ground shows through it, not one building through another.
  if (p.x != 0u) colour = mix(behind, colour, int(p.x) < nodeColoursCount ? buildingOpacity : contextOpacity);
  if (marked > 0.25) colour = marked > 0.75 ? selectedLine : hoverLine;
  outColour = vec4(colour, 1.0);
}
)";

}  // namespace lodestone
