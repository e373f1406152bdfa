// SPDX-FileCopyrightText: 2026 Fallen Person Detector contributors
// SPDX-License-Identifier: BSD-3-Clause
// True ellipsoids, one quad a cell: the quad covers the cell on the screen, and every pixel asks where its
// ray meets the ellipsoid. Exact at any distance, and 12 000 triangles for 6 000 cells.
//
// All data of a cell come from a texture (tools/view/scene/cell_texels.hpp), by the number of the vertex:
// nothing has to be computed for a cell in JavaScript, and software renderers, which are slow with instances,
// draw it in one go. The ellipsoid is the image of the unit sphere under A = sigmas * L with C = L L': in the
// coordinates of that sphere, inverse(A) (p - mean), the ray is still a ray.

export const kColorModes = ['score', 'cluster', 'height', 'age'];
/// Cells in a row of the texture.
export const kCellsPerRow = 256;

const cellData = `
  uniform highp isampler2D cells;
  uniform vec3 origin;
  uniform float placeStep;
  uniform float rootStep;
  uniform float sigmas;
  uniform int mode;
  uniform vec4 floorPlane;  // normal and offset, map frame
  uniform vec2 range;       // ends of the ramp
  uniform sampler2D ramp;
  uniform sampler2D clusterColors;
  uniform vec3 plainColor;
  uniform vec3 knownColor;

  vec3 fromRamp(float value) {
    return textureLod(ramp, vec2(clamp((value - range.x) / (range.y - range.x), 0.0, 1.0), 0.5), 0.0).rgb;
  }

  vec3 colorOf(vec3 mean, int cluster, int score, int age) {
    if (mode == 2) return fromRamp(dot(floorPlane.xyz, mean) + floorPlane.w);
    if (mode == 3) return fromRamp(float(age) * 0.1);
    if (cluster == -2) return knownColor;
    if (mode == 0) return score == -32768 ? plainColor : fromRamp(float(score) / 32767.0);
    return cluster < 0 ? plainColor : texelFetch(clusterColors, ivec2(cluster % 8, 0), 0).rgb;
  }
`;

export const vertexShader = `
  ${cellData}
  out vec3 ray;                 // from the eye through the pixel, sphere coordinates
  flat out vec3 eye;            // sphere coordinates
  flat out mat3 normals;        // from sphere coordinates to the view's
  flat out vec3 cellColor;
  flat out vec4 depthOfEye;     // z and w on the screen of the eye's place; of a step along the ray below
  out vec2 depthOfRay;

  // Half axes of the ellipse that a covariance makes on the screen: tight, so that few pixels are asked
  // in vain.
  mat2 halfAxes(float xx, float xy, float yy) {
    float middle = 0.5 * (xx + yy);
    float spread = length(vec2(0.5 * (xx - yy), xy));
    vec2 along = abs(xy) > 1e-12 ? normalize(vec2(xy, middle + spread - xx)) : xx >= yy ? vec2(1, 0) : vec2(0, 1);
    return mat2(along * sqrt(max(middle + spread, 0.0)),
                vec2(-along.y, along.x) * sqrt(max(middle - spread, 1e-8)));
  }

  void main() {
    int cell = gl_VertexID >> 2;
    ivec2 texel = ivec2(3 * (cell % ${kCellsPerRow}), cell / ${kCellsPerRow});
    ivec4 place = texelFetch(cells, texel, 0);
    ivec4 upper = texelFetch(cells, texel + ivec2(1, 0), 0);
    ivec4 lower = texelFetch(cells, texel + ivec2(2, 0), 0);
    vec3 mean = origin + vec3(place.xyz) * placeStep;
    cellColor = colorOf(mean, place.w, upper.w, lower.w);

    // A, lower triangular, by columns; flat ones stay invertible.
    vec3 a = vec3(upper.xyz) * rootStep * sigmas;
    vec3 b = vec3(lower.xyz) * rootStep * sigmas;
    float thin = 4e-4;
    mat3 A = mat3(max(a.x, thin), a.y, b.x, 0.0, max(a.z, thin), b.y, 0.0, 0.0, max(b.z, thin));
    mat3 toView = mat3(modelViewMatrix) * A;
    vec3 meanView = (modelViewMatrix * vec4(mean, 1.0)).xyz;

    // The quad faces the eye, in the mean's distance.
    vec3 forward = normalize(meanView);
    vec3 right = normalize(cross(forward, vec3(0.0, 1.0, 0.0)));
    vec3 up = cross(right, forward);
    vec3 r = right * toView;
    vec3 u = up * toView;
    mat2 axes = halfAxes(dot(r, r), dot(r, u), dot(u, u));
    float size = length(r) + length(u);
    float near = 1.0 + size / max(length(meanView) - size, 0.05);  // perspective shows a little more
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    vec2 offset = axes * corner * near;
    vec3 pointView = meanView + right * offset.x + up * offset.y;

    mat3 fromView = inverse(toView);
    eye = fromView * -meanView;
    ray = fromView * pointView;
    normals = transpose(fromView);
    gl_Position = projectionMatrix * vec4(pointView, 1.0);
    vec4 rayClip = projectionMatrix * vec4(pointView, 0.0);
    vec4 eyeClip = projectionMatrix * vec4(0.0, 0.0, 0.0, 1.0);
    depthOfEye = vec4(eyeClip.zw, 0.0, 0.0);
    depthOfRay = rayClip.zw;
  }
`;

export const fragmentShader = `
  in vec3 ray;
  flat in vec3 eye;
  flat in mat3 normals;
  flat in vec3 cellColor;
  flat in vec4 depthOfEye;
  in vec2 depthOfRay;
  out vec4 color;

  void main() {
    // |eye + t ray| = 1, the nearer solution.
    float a = dot(ray, ray);
    float b = dot(eye, ray);
    float d = b * b - a * (dot(eye, eye) - 1.0);
    if (d < 0.0) discard;
    float t = (-b - sqrt(d)) / a;
    vec3 n = normalize(normals * (eye + t * ray));
    float light = 0.5 + 0.5 * dot(n, vec3(-0.352, 0.755, 0.553));
    color = vec4(cellColor * (0.42 + 0.62 * light), 1.0);
    #ifdef EXACT_DEPTH
      vec2 zw = depthOfEye.xy + t * depthOfRay;
      gl_FragDepth = 0.5 + 0.5 * zw.x / zw.y;
    #endif
  }
`;
