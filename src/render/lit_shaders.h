#pragma once

#include <string_view>

// GLSL 4.00 sources of what is lit. LitProgram puts the version, the macros and `lighting` before them.
namespace roomgen::detail::shaders {

/// Before fragments that are lit: a sun with soft shadows, light from all sides, a hint of gloss. INDOORS has an eye in
/// the room, and the light of LIGHTS windows and lamps, the first WINDOWS of
/// which are windows.
inline constexpr std::string_view lighting = R"(
uniform mat4 sun_from_pixel;
uniform mat4 room_from_pixel;
uniform vec3 to_sun;
uniform vec3 to_sky;             // where the ambient light is brightest
#ifdef INDOORS
uniform vec3 eye;
#if LIGHTS > 0
uniform vec3 light_places[LIGHTS];
uniform vec3 light_colors[LIGHTS];  // times the light that falls on what faces it at 1 m
uniform vec4 light_axes[LIGHTS];    // w: cosine of the cone's half angle
#endif
#else
uniform vec3 to_viewer;
#endif
uniform sampler2DShadow sun_depth;
uniform float shadow_width;      // of a shadow's soft edge, in parts of the map

// Four times four neighbouring taps. They draw together where the sun grazes, lest a surface shades itself.
float sunlight(vec3 sample_place, float facing) {
  vec4 there = sun_from_pixel * vec4(sample_place, 1.0);
  vec3 at = there.xyz / there.w;
  vec2 one = vec2(0.3, 0.8) * (shadow_width * facing), other = vec2(one.y, -one.x);
  vec4 lit = textureGather(sun_depth, at.xy + one, at.z) + textureGather(sun_depth, at.xy - one, at.z) +
             textureGather(sun_depth, at.xy + other, at.z) + textureGather(sun_depth, at.xy - other, at.z);
  return dot(lit, vec4(0.0625));
}

#ifdef INDOORS
const vec3 darkest = vec3(0.46, 0.45, 0.43), brightest = vec3(0.70, 0.70, 0.69);

#if LIGHTS > 0
// As a plane shines.
vec3 light_of_window(int i, vec3 room, vec3 n) {
  vec3 way = light_places[i] - room;
  float squared = dot(way, way);
  float facing = max(dot(n, way), 0.0) * max(-dot(way, light_axes[i].xyz), 0.0);
  return light_colors[i] * (facing / (squared * (squared + 0.05)));
}

// smoothstep() without divisions.
float smooth_between(float x) {
  float t = clamp(x, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

vec3 light_of_lamp(int i, vec3 room, vec3 n) {
  vec3 way = light_places[i] - room;
  float squared = dot(way, way);
  way *= inversesqrt(squared);
  float down = -dot(way, light_axes[i].xyz);
  float facing = max(dot(n, way), 0.0) * smooth_between((down - light_axes[i].w + 0.15) * 3.333333);
  // Shades let the light through: what is around the bulb glows, whichever way it faces.
  facing = max(facing, 0.16 * smooth_between(1.4 - 20.0 * squared));
  return light_colors[i] * (facing / (squared + 0.05));
}
#endif

// Lamps and windows cast no shadows of their own: what they leave in the dark, occlusion finds.
vec3 light_of_the_room(vec3 room, vec3 n) {
  vec3 sum = vec3(0.0);
#if LIGHTS > 0
  for (int i = 0; i < WINDOWS; ++i) sum += light_of_window(i, room, n);
  for (int i = WINDOWS; i < LIGHTS; ++i) sum += light_of_lamp(i, room, n);
#endif
  return sum;
}
#else
const vec3 darkest = vec3(0.36, 0.345, 0.33), brightest = vec3(0.58, 0.58, 0.59);
#endif

vec3 place_in_room(vec3 sample_place) {
  vec4 here = room_from_pixel * vec4(sample_place, 1.0);
  return here.xyz / here.w;
}

// Of any length.
vec3 way_to_viewer(vec3 room) {
#ifdef INDOORS
  return eye - room;
#else
  return to_viewer;
#endif
}

// Furniture of many hands: triangles may be wound either way.
vec3 turned_to_viewer(vec3 n, vec3 room) { return dot(n, way_to_viewer(room)) < 0.0 ? -n : n; }

struct Light {
  vec3 diffuse;
  float highlight;
};

Light light_at(vec3 sample_place, vec3 room, vec3 n) {
  float facing = max(dot(n, to_sun), 0.0);
  float sun = facing > 0.0 ? facing * sunlight(sample_place, facing) : 0.0;
  float side = 0.5 + 0.5 * dot(n, to_sky);
  vec3 diffuse = mix(darkest, brightest, side) + sun * vec3(0.86, 0.81, 0.74);
#ifdef INDOORS
  diffuse += light_of_the_room(room, n);
#endif
  float highlight = max(dot(n, normalize(normalize(way_to_viewer(room)) + to_sun)), 0.0);
  highlight *= highlight; highlight *= highlight; highlight *= highlight; highlight *= highlight;
  return Light(diffuse, 0.35 * highlight * sun);
}

// What glows has its glow, negative, in place of the roughness.
vec3 shown(vec3 albedo, float roughness, Light light) {
  vec3 color = albedo * light.diffuse;
  if (roughness < -0.01) color = mix(color, 1.5 * albedo + 0.1, -roughness);
  else color += (1.0 - roughness) * (1.0 - roughness) * light.highlight;
  // Highlights roll off instead of clipping.
  color *= 1.06 - 0.2 * min(color, vec3(1.5));
  // sRGB within 0.02, without a power function.
  color = sqrt(color);
  return color * (1.13 - 0.13 * color);
}
)";

/// Glass and curtains, lit sample by sample; colours times their opacity. Variant by macro: TEXTURED.
inline constexpr std::string_view glass_fragment = R"(
in vec3 room_normal;
in vec2 texture_uv;
flat in vec4 tint;
flat in float roughness;
uniform sampler2D base_color;
out vec4 pixel;
void main() {
  vec4 albedo = tint;
#ifdef TEXTURED
  vec4 texel = texture(base_color, texture_uv);
  albedo *= vec4(texel.rgb * texel.rgb * (0.3 * texel.rgb + 0.7), texel.a);
#endif
  vec3 room = place_in_room(gl_FragCoord.xyz);
  vec3 n = turned_to_viewer(normalize(room_normal), room);
  pixel = vec4(shown(albedo.rgb, roughness, light_at(gl_FragCoord.xyz, room, n)) * albedo.a, albedo.a);
}
)";

/// The picture: four samples a pixel, lit together where they are alike, darkened where the sky is hidden.
inline constexpr std::string_view light_fragment = R"(
uniform sampler2D paint_map, facing_map, depth_map, glass_map;  // at twice the size
uniform sampler2D occlusion_map;
uniform ivec2 limit;
uniform vec3 background;
out vec4 pixel;

const float alike = 0.98;  // cosine between normals
const float flush = 0.03;  // metres beside each other's plane

// A normal as it is stored is nearly a unit long: one step of Newton's makes it one.
vec3 facing_of(vec4 stored, vec3 room) {
  vec3 n = 2.0 * stored.xyz - 1.0;
  return turned_to_viewer(n * (1.5 - 0.5 * dot(n, n)), room);
}

vec3 sample_place(ivec2 q) { return vec3(vec2(q) + 0.5, texelFetch(depth_map, q, 0).r); }

float sky_seen(ivec2 p) {
  // The pattern of the occlusion repeats every three pixels: the mean over 3 x 3 removes it.
  float center = texelFetch(occlusion_map, p, 0).g;
  float sum = 0.0, weights = 0.0;
  for (int y = -1; y < 2; ++y)
    for (int x = -1; x < 2; ++x) {
      vec2 other = texelFetch(occlusion_map, clamp(p + ivec2(x, y), ivec2(0), limit - 1), 0).rg;
      float weight = abs(other.g - center) < 0.08 ? 1.0 : 0.001;
      sum += weight * other.r;
      weights += weight;
    }
  return sum / weights;
}

void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  ivec2 a = 2 * p, b = a + ivec2(1, 0), c = a + ivec2(0, 1), d = a + ivec2(1, 1);
  vec3 at_a = sample_place(a), at_b = sample_place(b), at_c = sample_place(c), at_d = sample_place(d);
  vec3 room_a = place_in_room(at_a), room_b = place_in_room(at_b), room_c = place_in_room(at_c),
       room_d = place_in_room(at_d);
  vec4 facing_a = texelFetch(facing_map, a, 0), facing_b = texelFetch(facing_map, b, 0),
       facing_c = texelFetch(facing_map, c, 0), facing_d = texelFetch(facing_map, d, 0);
  vec3 n_a = facing_of(facing_a, room_a), n_b = facing_of(facing_b, room_b), n_c = facing_of(facing_c, room_c),
       n_d = facing_of(facing_d, room_d);
  vec4 paint_a = texelFetch(paint_map, a, 0), paint_b = texelFetch(paint_map, b, 0),
       paint_c = texelFetch(paint_map, c, 0), paint_d = texelFetch(paint_map, d, 0);
  vec4 glass_a = texelFetch(glass_map, a, 0), glass_b = texelFetch(glass_map, b, 0),
       glass_c = texelFetch(glass_map, c, 0), glass_d = texelFetch(glass_map, d, 0);

  // What glass lets through, of each sample.
  vec4 through = 1.0 - vec4(glass_a.a, glass_b.a, glass_c.a, glass_d.a);
  vec4 there = vec4(facing_a.a, facing_b.a, facing_c.a, facing_d.a);
  vec3 sum = glass_a.rgb + glass_b.rgb + glass_c.rgb + glass_d.rgb + background * dot(through, 1.0 - there);
  vec4 dark = there;  // those that no light has been worked out for
  for (int k = 0; k < 4 && dot(dark, vec4(1.0)) > 0.5; ++k) {
    vec3 at = at_d, room = room_d, n = n_d;
    if (dark.z > 0.5) { at = at_c; room = room_c; n = n_c; }
    if (dark.y > 0.5) { at = at_b; room = room_b; n = n_b; }
    if (dark.x > 0.5) { at = at_a; room = room_a; n = n_a; }
    vec4 cosines = vec4(dot(n, n_a), dot(n, n_b), dot(n, n_c), dot(n, n_d));
    vec4 beside = abs(vec4(dot(n, room_a - room), dot(n, room_b - room), dot(n, room_c - room), dot(n, room_d - room)));
    vec4 lit = dark * step(alike, cosines) * step(beside, vec4(flush));
    Light light = light_at(at, room, n);
    vec4 share = lit * through;
    sum += share.x * shown(paint_a.rgb * paint_a.rgb, 2.0 * paint_a.a - 1.0, light);
    sum += share.y * shown(paint_b.rgb * paint_b.rgb, 2.0 * paint_b.a - 1.0, light);
    sum += share.z * shown(paint_c.rgb * paint_c.rgb, 2.0 * paint_c.a - 1.0, light);
    sum += share.w * shown(paint_d.rgb * paint_d.rgb, 2.0 * paint_d.a - 1.0, light);
    dark -= lit;
  }
  pixel = vec4(0.25 * sum * (0.45 + 0.55 * sky_seen(p)), 1.0);
}
)";

}  // namespace roomgen::detail::shaders
