// Lines of more than a pixel for WebGL, as one mesh: eight corners a segment. Three.js draws an instance a segment
// (LineSegments2), which takes 90 µs each where no graphics processor draws: a path of 50 000 holds the page up for seconds.

import { BufferAttribute, BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute, Mesh } from "three";
import type { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";

// Of a segment, as the shader of LineMaterial has them: side (-1, 1) and place along it (0: its start, 1: its end, beyond:
// round ends), then where within its width a corner is.
const corners = [
  [-1, 2, -1, 2],
  [1, 2, 1, 2],
  [-1, 1, -1, 1],
  [1, 1, 1, 1],
  [-1, 0, -1, -1],
  [1, 0, 1, -1],
  [-1, -1, -1, -2],
  [1, -1, 1, -2],
].flat();
const triangles = [0, 2, 1, 2, 3, 1, 2, 4, 3, 4, 5, 3, 4, 6, 5, 6, 7, 5];
const cornersEach = 8;

/** So many times each triple. */
function repeated(triples: Float32Array, from: number, stride: number): Float32Array {
  const segments = triples.length / stride;
  const all = new Float32Array(segments * cornersEach * 3);
  for (let segment = 0, to = 0; segment < segments; ++segment)
    for (let corner = 0; corner < cornersEach; ++corner)
      for (let k = 0; k < 3; ++k) all[to++] = triples[segment * stride + from + k] ?? 0;
  return all;
}

function cornersOf(segments: number): InterleavedBuffer {
  const all = new Int8Array(corners.length * segments);
  for (let segment = 0; segment < segments; ++segment) all.set(corners, segment * corners.length);
  return new InterleavedBuffer(all, 4);
}

function indexOf(segments: number): Uint32Array {
  const all = new Uint32Array(triangles.length * segments);
  for (let segment = 0, to = 0; segment < segments; ++segment)
    for (const corner of triangles) all[to++] = segment * cornersEach + corner;
  return all;
}

/** `places` and `colours` of both ends, six numbers each; a segment has the colour of its second end. */
export function wideLines(places: Float32Array, colours: Float32Array, material: LineMaterial): Mesh {
  const segments = places.length / 6;
  const each = cornersOf(segments);
  const colour = new BufferAttribute(repeated(colours, 3, 6), 3);
  const geometry = new BufferGeometry()
    .setAttribute("position", new InterleavedBufferAttribute(each, 2, 0))
    .setAttribute("uv", new InterleavedBufferAttribute(each, 2, 2))
    .setAttribute("instanceStart", new BufferAttribute(repeated(places, 0, 6), 3))
    .setAttribute("instanceEnd", new BufferAttribute(repeated(places, 3, 6), 3))
    .setAttribute("instanceColorStart", colour)
    .setAttribute("instanceColorEnd", colour)
    .setIndex(new BufferAttribute(indexOf(segments), 1));
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false; // its corners are placed by the shader
  return mesh;
}
