#pragma once

#include <string_view>

// GLSL 4.00 sources. Pictures are drawn at twice their size and brought down, row 0 at the top: what the surfaces are
// like at each sample (surface_*), then the light, once for all samples of a pixel that are alike (light_fragment).
namespace roomgen::detail::shaders {

/// Objects and walls, seen by the camera.
inline constexpr std::string_view surface_vertex = R"(#version 400 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 normal;    // w: roughness, below 0 the glow
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;     // sRGB
uniform mat4 clip_from_model;
uniform mat3 room_from_normal;
out vec3 room_normal;
out vec2 texture_uv;
flat out vec4 tint;
flat out float roughness;

void main() {
  gl_Position = clip_from_model * vec4(position, 1.0);
  room_normal = room_from_normal * normal.xyz;
  roughness = normal.w;
  texture_uv = uv;
  tint = vec4(color.rgb * color.rgb * (0.3 * color.rgb + 0.7), color.a);
}
)";

/// What is there. Variants by macro: TEXTURED; MASKED drops transparent texels.
inline constexpr std::string_view surface_fragment = R"(
in vec3 room_normal;
in vec2 texture_uv;
flat in vec4 tint;
flat in float roughness;
uniform sampler2D base_color;
layout(location = 0) out vec4 paint;   // root of the linear colour; roughness, -1 to 1
layout(location = 1) out vec4 facing;  // normal in [0, 1]; 1: there is something
void main() {
  vec3 albedo = tint.rgb;
#ifdef TEXTURED
  vec4 texel = texture(base_color, texture_uv);
#ifdef MASKED
  if (texel.a < 0.4) discard;
#endif
  albedo *= texel.rgb * texel.rgb * (0.3 * texel.rgb + 0.7);
#endif
  paint = vec4(sqrt(albedo), 0.5 + 0.5 * roughness);
  facing = vec4(0.5 + 0.5 * normalize(room_normal), 1.0);
}
)";

/// Depth only, from the sun or the eye.
inline constexpr std::string_view shadow_vertex = R"(#version 400 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
uniform mat4 clip_from_model;
invariant gl_Position;
out vec2 texture_uv;
void main() {
  gl_Position = clip_from_model * vec4(position, 1.0);
  texture_uv = uv;
}
)";
inline constexpr std::string_view shadow_fragment = R"(
in vec2 texture_uv;
uniform sampler2D base_color;
void main() {
#ifdef MASKED
  if (texture(base_color, texture_uv).a < 0.4) discard;
#endif
}
)";

/// What the middle of each pixel shows: whose it is, how far it is, and which way it faces.
inline constexpr std::string_view layer_vertex = R"(#version 400 core
layout(location = 0) in vec3 position;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 color;
uniform mat4 clip_from_model;
uniform mat4 camera_from_model;  // metres to the right, up and backward
out vec3 place;
out vec2 texture_uv;
flat out float opacity;
void main() {
  gl_Position = clip_from_model * vec4(position, 1.0);
  place = (camera_from_model * vec4(position, 1.0)).xyz;
  texture_uv = uv;
  opacity = color.a;
}
)";
inline constexpr std::string_view layer_fragment = R"(
in vec3 place;
in vec2 texture_uv;
flat in float opacity;
uniform mat3 room_from_camera;
uniform bool has_eye;
uniform uint thing;
uniform float least_alpha;
uniform sampler2D base_color;
layout(location = 0) out vec4 surface;  // normal and distance
layout(location = 1) out uint number;
void main() {
  float alpha = opacity;
  vec3 normal = cross(dFdx(place), dFdy(place));
#ifdef TEXTURED
  alpha *= texture(base_color, texture_uv).a;
#endif
  if (alpha < least_alpha) discard;
  vec3 sight = has_eye ? place : vec3(0.0, 0.0, -1.0);
  if (!(dot(normal, normal) > 0.0)) normal = -sight;  // a sliver
  if (dot(normal, sight) > 0.0) normal = -normal;
  surface = vec4(normalize(room_from_camera * normal), -place.z);
  number = thing;
}
)";

/// One triangle over the whole target.
inline constexpr std::string_view screen_vertex = R"(#version 400 core
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// How much of the sky each pixel sees nearby (after McGuire et al., "The Alchemy Screen-Space Ambient
/// Obscurance Algorithm", 2011), and its depth in metres.
inline constexpr std::string_view occlusion_fragment = R"(#version 400 core
uniform sampler2D depth_map;      // of the picture at twice its size
uniform vec4 metres;              // (x d + y) / (z d + w) before the viewer, for a depth d
uniform vec2 scale;               // metres to a pixel, there and for every metre farther away
uniform vec2 middle;              // of the rays, in pixels of the tile
uniform vec2 radius;              // metres, and pixels at most
uniform ivec2 origin;             // of the tile, so that the pattern continues from tile to tile
uniform ivec2 limit;
out vec2 result;

const int samples = 9;
// Radii grow evenly, directions by the golden angle.
const vec2 spiral[samples] = vec2[](
    vec2(0.067, 0.0), vec2(-0.131, 0.120), vec2(0.025, -0.288), vec2(0.243, 0.317),
    vec2(-0.503, -0.089), vec2(0.527, -0.335), vec2(-0.190, 0.709), vec2(-0.389, -0.750),
    vec2(0.898, 0.328));

// Where the surface in a pixel is, seen by the viewer; z grows away from it.
vec3 place(ivec2 p) {
  float d = texelFetch(depth_map, 2 * clamp(p, ivec2(0), limit - 1), 0).r;
  float away = (metres.x * d + metres.y) / (metres.z * d + metres.w);
  return vec3((vec2(p) - middle) * (scale.x + scale.y * away), away);
}

vec3 shorter(vec3 a, vec3 b) { return abs(a.z) < abs(b.z) ? a : b; }

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec3 here = place(p);
  if (texelFetch(depth_map, 2 * p, 0).r >= 0.9999999) { result = vec2(1.0, here.z); return; }
  vec3 dx = shorter(place(p + ivec2(1, 0)) - here, here - place(p - ivec2(1, 0)));
  vec3 dy = shorter(place(p + ivec2(0, 1)) - here, here - place(p - ivec2(0, 1)));
  vec3 n = normalize(cross(dy, dx));

  float pixel = scale.x + scale.y * here.z;
  float reach = min(radius.x, radius.y * pixel);
  ivec2 cell = (p + origin) % 3;
  float turn = float((cell.x + 3 * cell.y) * 4 % 9) * 0.6981;
  mat2 spin = mat2(cos(turn), sin(turn), -sin(turn), cos(turn)) * (reach / pixel);
  float blocked = 0.0;
  for (int i = 0; i < samples; ++i) {
    vec3 v = place(p + ivec2(spin * spiral[i])) - here;
    float squared = dot(v, v);
    float fade = max(0.0, 1.0 - squared / (reach * reach));
    blocked += fade * max(0.0, dot(v, n) - 0.006) / (squared + 0.004);
  }
  result = vec2(max(0.0, 1.0 - blocked * reach * 2.0 / float(samples)), here.z);
}
)";

}  // namespace roomgen::detail::shaders
