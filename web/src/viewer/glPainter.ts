// SPDX-License-Identifier: MIT
/** Draws the body with three.js: points as cells or spheres with true depth, coloured through a lookup table. */
import {
  AddEquation, type BlendingDstFactor, type BlendingSrcFactor, BufferAttribute, BufferGeometry, Color, CustomBlending,
  DataTexture, DstAlphaFactor, DynamicDrawUsage, LineBasicMaterial, LineSegments, Matrix4, Mesh, NearestFilter,
  NoBlending, OneFactor, OrthographicCamera, Points, Scene, ShaderMaterial, Sphere, Vector3, WebGLRenderer, ZeroFactor,
} from "three";

import type { Camera, Vec } from "./camera";
import { type Body, type Painter, toLocal } from "./painter";

const pointVertices = `
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
const pointFragments = `
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

const plainVertices = `
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy, 0.0, 1.0); }`;
const screenVertices = `
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;
const plainFragments = `
void main() { gl_FragColor = vec4(1.0); }`;

interface Measures {
  /** Device pixels of a metre. */
  pixelsOfMetre: number;
  /** Largest point [device pixels] that the graphics processor draws. */
  largest: number;
  /** Change of depth, as stored, along one metre. */
  depthOfMetre: number;
}

function makePointMeshes(scene: Scene) {
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

function makeMaterial(
  vertexShader: string,
  colour: BlendingDstFactor,
  source: BlendingSrcFactor,
  opacity: BlendingDstFactor,
) {
  return new ShaderMaterial({
    vertexShader,
    fragmentShader: plainFragments,
    depthTest: false,
    depthWrite: false,
    transparent: true,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: ZeroFactor,
    blendDst: colour,
    blendSrcAlpha: source,
    blendDstAlpha: opacity,
  });
}

function makeCoverMeshes(scene: Scene) {
  // Triangles keep the colours and set the opacity to 1; they run either way round.
  const opaque = makeMaterial(plainVertices, OneFactor, OneFactor, ZeroFactor);
  opaque.side = 2;
  // Then colours are multiplied by the opacity, which is how the page expects them.
  const multiply = makeMaterial(screenVertices, DstAlphaFactor, ZeroFactor, OneFactor);
  const triangles = new Mesh(new BufferGeometry(), opaque);
  const corners = Float32Array.of(-1, -1, 0, 3, -1, 0, -1, 3, 0);
  const screen = new Mesh(new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3)), multiply);
  [triangles, screen].forEach((mesh, i) => {
    mesh.frustumCulled = false;
    mesh.renderOrder = 2 + i;
    scene.add(mesh);
  });
  const everywhere = new Sphere(new Vector3(), 1e9);
  let drawn: Float64Array | null = null;

  function set(body: Body): void {
    triangles.visible = screen.visible = body.cover !== null && body.showPoints;
    if (!body.cover || body.cover.triangles === drawn) return;
    drawn = body.cover.triangles;
    triangles.geometry.dispose();
    triangles.geometry = new BufferGeometry().setAttribute(
      "position",
      new BufferAttribute(toLocal(drawn, 2, body.origin), 2).setUsage(DynamicDrawUsage),
    );
    triangles.geometry.boundingSphere = everywhere;
  }

  function dispose(): void {
    for (const mesh of [triangles, screen]) mesh.geometry.dispose();
    opaque.dispose();
    multiply.dispose();
  }
  return { set, dispose };
}

/** `margin` [px]: how far the eye sees beyond each edge of the canvas. */
function setEye(eye: OrthographicCamera, camera: Camera, origin: Vec, reach: number, margin: number): void {
  const { right, up, near } = camera.findAxes();
  const [cx, cy] = camera.centre;
  eye.left = -(cx + margin) / camera.scale;
  eye.right = (camera.width - cx + margin) / camera.scale;
  eye.top = (cy + margin) / camera.scale;
  eye.bottom = -(camera.height - cy + margin) / camera.scale;
  eye.near = 0;
  eye.far = 2 * reach;
  eye.updateProjectionMatrix();
  const [r, u, n] = [right, up, near].map((v) => new Vector3(...v)) as [Vector3, Vector3, Vector3];
  const target = new Vector3(...camera.target).sub(new Vector3(...origin));
  eye.matrix = new Matrix4().makeBasis(r, u, n).setPosition(target.addScaledVector(n, reach));
  eye.matrixWorldNeedsUpdate = true;
}

/** Throws where the browser offers no WebGL. */
export function makeGlPainter(onLost: () => void): Painter {
  const canvas = document.createElement("canvas");
  // The drawing is kept for whoever prints or copies the canvas; edges are smooth enough without antialiasing.
  const wishes = { antialias: false, alpha: true, depth: true, preserveDrawingBuffer: true };
  const context = canvas.getContext("webgl2", wishes) as WebGL2RenderingContext | null;
  if (!context) throw new Error("no WebGL");
  const renderer = new WebGLRenderer({ canvas, context, ...wishes });
  renderer.setClearColor(0x000000, 0);
  canvas.addEventListener("webglcontextlost", onLost);
  const largest = (context.getParameter(context.ALIASED_POINT_SIZE_RANGE) as Float32Array)[1]!;
  const scene = new Scene();
  const eye = new OrthographicCamera();
  eye.matrixAutoUpdate = false;
  const points = makePointMeshes(scene);
  const cover = makeCoverMeshes(scene);

  const line = new LineBasicMaterial({ transparent: true, opacity: 0.3 });
  const edges = new LineSegments(new BufferGeometry(), line);
  edges.frustumCulled = false;
  edges.renderOrder = 4;
  scene.add(edges);
  let drawnEdges: Float64Array | null = null;

  function setEdges(body: Body): void {
    edges.visible = body.edges !== null;
    if (!body.edges) return;
    line.color = new Color(body.edgeColour);
    // A section's mesh is in front of the points, in space it runs through them.
    line.depthTest = !body.cover;
    if (body.edges === drawnEdges) return;
    edges.geometry.dispose();
    edges.geometry = new BufferGeometry().setAttribute(
      "position",
      new BufferAttribute(toLocal(body.edges, 3, body.origin), 3),
    );
    drawnEdges = body.edges;
  }

  return {
    canvas,
    resize(width, height, density) {
      renderer.setPixelRatio(density);
      renderer.setSize(width, height);
    },
    draw(body, camera) {
      const reach = 2 * body.extent;
      const pixelsOfMetre = camera.scale * renderer.getPixelRatio();
      points.set(body, { pixelsOfMetre, largest, depthOfMetre: 1 / (2 * reach) });
      // A point whose middle is out of sight is not drawn at all: sight goes beyond the edges as far as points do.
      const margin = Math.ceil(points.findLongest() * camera.scale) + 1;
      setEye(eye, camera, body.origin, reach, margin);
      renderer.setViewport(-margin, -margin, camera.width + 2 * margin, camera.height + 2 * margin);
      cover.set(body);
      setEdges(body);
      renderer.render(scene, eye);
    },
    dispose() {
      canvas.removeEventListener("webglcontextlost", onLost);
      points.dispose();
      cover.dispose();
      edges.geometry.dispose();
      line.dispose();
      renderer.dispose();
    },
  };
}
