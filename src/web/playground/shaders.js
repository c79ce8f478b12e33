// SPDX-License-Identifier: MIT
//
// The shaders of the view in space. Lengths are widths of the terrain; colours are those of the
// screen, which are about the roots of light.

const HEAD = `#version 300 es
precision highp float;
`;

// The colour of the sky in the direction of a unit vector. Low suns redden it around them. Below
// the horizon it darkens, since there is nothing.
const SKY = `
uniform vec3 sun; // a unit vector to it
uniform float low; // how low the sun is, from 0 to 1
uniform float night; // 0 on light pages, 1 on dark ones
vec3 sky(vec3 ray) {
    float toward = max(dot(ray, sun), 0.0);
    vec3 horizon = mix(vec3(0.80, 0.86, 0.91), vec3(0.90, 0.80, 0.71), low);
    horizon = mix(horizon, vec3(0.98, 0.76, 0.53), low * toward * toward);
    vec3 zenith = mix(vec3(0.29, 0.49, 0.76), vec3(0.27, 0.37, 0.57), low);
    float thin = 1.0 - 0.5 * (ray.z + sqrt(ray.z * ray.z + 0.004)); // no edge at the horizon
    vec3 colour = mix(zenith, horizon, thin * thin * thin);
    colour = mix(colour, horizon * vec3(0.74, 0.76, 0.79), smoothstep(0.0, -0.8, ray.z));
    float near = toward * toward * toward * toward;
    near *= near;
    colour += mix(vec3(0.10, 0.09, 0.06), vec3(0.22, 0.13, 0.05), low) * near;
    return mix(colour, colour * vec3(0.30, 0.32, 0.37) + vec3(0.015, 0.02, 0.03), night);
}
`;

// Vertices of the grid, then those of their feet: see mesh.js. What is far takes the colour of the
// sky behind it, and water mirrors the sky where it is looked at flatly: of the ground's colour
// `keep` stays, and `more` is added. That changes slowly, so vertices do it.
export const GROUND = HEAD + SKY + `
uniform highp sampler2D heights;
uniform mat4 camera;
uniform vec3 scale; // of sample numbers and values
uniform float middle; // the value at the height 0 of space
uniform float base; // the height of feet
uniform float sea; // the height of the sea
uniform bool is_mirror; // whether the sea is one
uniform vec3 eye;
uniform ivec2 size, grid, mesh; // samples; those with heights; those with vertices
uniform int every, times; // of how many samples there is a height; of how many of these a vertex
out vec2 place;
out vec3 spot, more;
out float top, keep; // the height of the surface here
void main() {
    int number = gl_VertexID, all = mesh.x * mesh.y;
    bool is_foot = number >= all;
    number -= is_foot ? all : 0;
    ivec2 place_in_grid = min(ivec2(number % mesh.x, number / mesh.x) * times, grid - 1);
    ivec2 at = min(place_in_grid * every, size - 1);
    top = (texelFetch(heights, place_in_grid, 0).r - middle) * scale.z;
    vec2 flat_spot = (vec2(at) - 0.5 * vec2(size - 1)) * scale.xy * vec2(1.0, -1.0);
    spot = vec3(flat_spot, is_foot ? base : top);
    place = (vec2(at) + 0.5) / vec2(size);
    gl_Position = camera * vec4(spot, 1.0);

    vec3 way = spot - eye;
    float far = length(way), haze = 0.8 * (1.0 - exp(-0.1 * far * far));
    vec3 ray = way / max(far, 1e-6);
    more = sky(normalize(vec3(ray.xy, max(ray.z, 0.0) + 0.03))) * haze;
    keep = 1.0 - haze;
    if (is_mirror && abs(top - sea) < 2e-6) {
        float flat_look = 1.0 - abs(ray.z), twice = flat_look * flat_look;
        float mirror = 0.02 + 0.75 * twice * twice * flat_look;
        more += sky(vec3(ray.xy, abs(ray.z))) * keep * mirror;
        keep *= 1.0 - mirror;
    }
}`;

export const SURFACE = HEAD + `
uniform sampler2D sunlit;
in vec2 place;
in vec3 more;
in float keep;
out vec4 colour;
void main() {
    colour = vec4(texture(sunlit, place).rgb * keep + more, 1.0);
}`;

// The pixels of the map have the light of a sun that nothing hides. Shadows keep the share of the
// sky, in which the ground has less contrast: so they take pixels from a wider area, too. This is
// drawn once for each terrain and sun, into a texture.
export const SUNLIT = HEAD + `
uniform sampler2D colours, lights;
uniform vec3 sunlight, skylight; // on the map's pixels
uniform vec3 tint; // of the sun, against the map's
in vec2 place;
out vec4 colour;
void main() {
    vec2 light = texture(lights, place).rg;
    vec3 direct = sunlight * light.g, around = sunlight * textureLod(lights, place, 2.0).g;
    vec3 ground = texture(colours, place).rgb;
    vec3 shaded = mix(ground, textureLod(colours, place, 2.0).rgb, 0.7);
    shaded *= sqrt(skylight / (around + skylight));
    ground *= sqrt((direct * tint + skylight) / (direct + skylight));
    colour = vec4(mix(shaded, ground, light.r), 1.0);
}`;

// Walls are cuts through layers of earth, below a rim of the surface's colour; below the sea that
// rim is thicker. The base is dark.
export const BLOCK = HEAD + `
uniform sampler2D sunlit;
uniform vec3 eye, sun;
uniform float base, sea;
in vec2 place;
in vec3 spot, more;
in float top, keep;
out vec4 colour;
void main() {
    float depth = top - spot.z, high = top - base;
    vec3 normal = normalize(cross(dFdx(spot), dFdy(spot)));
    normal *= dot(normal, spot - eye) > 0.0 ? -1.0 : 1.0;
    float bend = 0.004 * sin(9.0 * spot.x + 5.0 * spot.y);
    bend += 0.003 * sin(23.0 * spot.x - 17.0 * spot.y);
    float layer = spot.z + bend;
    float stripe = sin(190.0 * layer) + 0.6 * sin(83.0 * layer + 1.0) + 0.4 * sin(417.0 * layer);
    vec3 earth = vec3(0.46, 0.40, 0.35) + 0.022 * stripe;
    earth *= 1.0 - 0.35 * clamp(depth / max(high, 1e-6), 0.0, 1.0);
    bool is_sea = abs(top - sea) < 2e-6;
    float rim = is_sea ? 0.3 * high : 0.005;
    float share = 1.0 - smoothstep(is_sea ? 0.0 : 0.6 * rim, rim, depth);
    vec3 skin = texture(sunlit, place).rgb * (is_sea ? 1.1 : 1.0);
    vec3 cut = mix(earth, skin, (is_sea ? 0.9 : 0.85) * share);
    cut *= normal.z < -0.5 ? 0.45 : 0.66 + 0.42 * max(dot(normal, sun), 0.0);
    colour = vec4(cut * keep + more, 1.0);
}`;

// One triangle that covers the picture, behind all; `place` is from 0 to 1 in it.
export const PICTURE = HEAD + `
uniform mat3 rays; // Camera.rays
out vec3 way;
out vec2 place;
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    way = rays * vec3(corner, 1.0);
    place = 0.5 + 0.5 * corner;
    gl_Position = vec4(corner, 1.0, 1.0);
}`;

// Half a step of noise hides the steps of a gradient.
export const HEAVEN = HEAD + SKY + `
in vec3 way;
out vec4 colour;
void main() {
    vec3 ray = normalize(way), shown = sky(ray);
    float toward = dot(ray, sun);
    if (toward > 0.9) {
        float disc = smoothstep(0.99988, 0.99992, toward) * smoothstep(-0.004, 0.004, ray.z);
        disc += 0.4 * exp(300.0 * (toward - 1.0));
        vec3 bright = mix(vec3(1.0, 0.98, 0.92), vec3(1.0, 0.86, 0.62), low);
        shown = mix(shown, bright * (1.0 - 0.15 * night), min(disc, 1.0));
    }
    float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    colour = vec4(shown + (noise - 0.5) / 255.0, 1.0);
}`;
