// SPDX-License-Identifier: MIT
/** The points of the body in WebGL, as point sprites. Instances of a square would be ten times slower in software. */
import {
  BufferAttribute, BufferGeometry, DataTexture, DynamicDrawUsage, NearestFilter, NoBlending, Points, ShaderMaterial,
  Sphere, Vector3, type Scene,
} from "three";

import { toLocal, type Body } from "./painter";
import { pointFragments, pointVertices } from "./shaders";

interface Measures {
  /** Device pixels of a metre. */
  pixelsOfMetre: number;
  /** Largest point [device pixels] that the graphics processor draws. */
  largest: number;
  /** Change of depth, as stored, along one metre. */
  depthOfMetre: number;
}

export function makePointMeshes(scene: Scene) {
  const colours = new DataTexture(new Uint8Array(1024), 256, 1);
  colours.minFilter = colours.magFilter = NearestFilter;
  const uniforms = {
    least: { value: 0 },
    most: { value: 1 },
    pixelsOfMetre: { value: 1 },
    depthOfMetre: { value: 0 },
    longest: { value: 1 },
    flatCells: { value: false },
    logarithmic: { value: false },
    walls: { value: [0, 0, 0] },
    limits: { value: [0, 1] },
    colours: { value: colours },
  };
  const material = new ShaderMaterial({
    uniforms,
    vertexShader: pointVertices,
    fragmentShader: pointFragments,
    blending: NoBlending,
  });
  let geometry = new BufferGeometry();
  const everywhere = new Sphere(new Vector3(), 1e9);
  let count = -1;
  let longestOf: Float32Array | null = null;
  let longest = 0;
  /** A section is drawn several times behind itself to be seen as a slab. */
  const slices: Points[] = [];

  /** Uploads an array; the buffer on the device is kept while its size stays. */
  function setAttribute(name: string, array: Float32Array, itemSize: number): void {
    const old = geometry.getAttribute(name) as BufferAttribute | undefined;
    if (!old) {
      geometry.setAttribute(name, new BufferAttribute(array, itemSize).setUsage(DynamicDrawUsage));
    } else if (old.array.byteOffset !== array.byteOffset || old.array.buffer !== array.buffer) {
      old.array = array;
      old.needsUpdate = true;
    }
  }

  /** Frames are views of one array: the offset of a view identifies its frame. */
  let placed = { buffer: null as ArrayBufferLike | null, at: -1, local: new Float32Array() };
  function setPositions({ positions, dimension, origin }: Body): void {
    const { buffer, byteOffset: at } = positions;
    if (placed.buffer !== buffer || placed.at !== at)
      placed = { buffer, at, local: toLocal(positions, dimension, origin) as Float32Array<ArrayBuffer> };
    setAttribute("position", placed.local, dimension);
  }

  function set(body: Body, measures: Measures): void {
    if (count !== body.count) {
      geometry.dispose();
      geometry = new BufferGeometry();
      for (const slice of slices) slice.geometry = geometry;
      count = body.count;
    }
    setPositions(body);
    setAttribute("value", body.values, 1);
    setAttribute("radius", body.radii, 1);
    setAttribute("reach", body.cover?.reach ?? body.radii, 1);
    while (slices.length < body.slices.length) {
      const slice = new Points(geometry, material);
      slice.frustumCulled = false;
      slice.renderOrder = 1;
      slices.push(slice);
      scene.add(slice);
    }
    slices.forEach((slice, i) => {
      slice.visible = body.showPoints && i < body.slices.length;
      slice.position.z = body.slices[i] ?? 0;
    });
    if (colours.image.data !== body.colours) {
      colours.image.data = body.colours as Uint8Array<ArrayBuffer>;
      colours.needsUpdate = true;
    }
    geometry.boundingSphere = everywhere;
    if (longestOf !== body.radii) {
      longestOf = body.radii;
      longest = 1.001 * body.radii.reduce((most, r) => Math.max(most, Math.abs(r)), 1e-9);
    }
    const least = 0.75 / measures.pixelsOfMetre;
    uniforms.longest.value = longest + least;
    uniforms.least.value = least;
    uniforms.most.value = Math.max(least, measures.largest / 2 / measures.pixelsOfMetre);
    uniforms.pixelsOfMetre.value = measures.pixelsOfMetre;
    uniforms.depthOfMetre.value = measures.depthOfMetre;
    uniforms.flatCells.value = body.cover !== null;
    uniforms.logarithmic.value = body.scale.logarithmic;
    uniforms.limits.value = [body.scale.low, body.scale.high];
    const [x, y] = body.origin;
    uniforms.walls.value = [body.walls[0] - x, body.walls[1] - y, body.walls[2] - x];
  }

  function dispose(): void {
    geometry.dispose();
    material.dispose();
    colours.dispose();
  }
  /** Radius [m] of the largest point. */
  const findLongest = () => Math.min(uniforms.longest.value, uniforms.most.value);
  return { set, findLongest, dispose };
}
