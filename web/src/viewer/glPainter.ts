/** Draws the body with three.js: spheres as point sprites with true depth, coloured through a lookup table. */
import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  DynamicDrawUsage,
  LinearFilter,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  OrthographicCamera,
  Points,
  Scene,
  ShaderMaterial,
  Sphere,
  Vector3,
  WebGLRenderer,
} from "three";

import type { Camera } from "./camera";
import type { Body, Painter } from "./painter";

const vertexShader = `
attribute float value;
uniform float pixels;
uniform vec2 limits;
uniform vec3 cutLow, cutHigh;
varying float place;
varying float none;
varying vec2 middle;
void main() {
  middle = position.xy;
  none = value > -1e30 && value < 1e30 ? 0.0 : 1.0;
  place = none > 0.5 ? 0.0 : (clamp((value - limits.x) / (limits.y - limits.x), 0.0, 1.0) * 255.0 + 0.5) / 256.0;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  if (any(lessThan(position, cutLow)) || any(greaterThan(position, cutHigh))) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = pixels;
}`;

// The depth of a sphere's surface decides between neighbours. Seen from the front every pixel so belongs to the nearest
// point, and the points fill the body with cells instead of overlapping by their order.
const fragmentShader = `
uniform sampler2D colours;
uniform float radius;
uniform float shade;
uniform float reach;
uniform vec4 walls;
varying float place;
varying float none;
varying vec2 middle;
void main() {
  vec2 d = 2.0 * gl_PointCoord - 1.0;
  float rest = 1.0 - dot(d, d);
  if (rest < 0.0) discard;
  vec2 at = middle + reach * vec2(d.x, -d.y);
  if (shade < 0.5 && (any(lessThan(at, walls.xy)) || any(greaterThan(at, walls.zw)))) discard;
  float bulge = sqrt(rest);
  gl_FragDepth = gl_FragCoord.z - radius * bulge;
  vec3 colour = none > 0.5 ? vec3(0.6) : texture2D(colours, vec2(place, 0.5)).rgb;
  float light = dot(vec3(d.x, -d.y, bulge), vec3(-0.35, 0.5, 0.79));
  gl_FragColor = vec4(colour * mix(1.0, 0.74 + 0.3 * max(light, 0.0), shade), 1.0);
}`;

/** Throws where the browser offers no WebGL. */
export function makeGlPainter(onLost: () => void): Painter {
  const canvas = document.createElement("canvas");
  // The drawing is kept for whoever prints or copies the canvas; edges are smooth enough without antialiasing.
  const wishes = { antialias: false, alpha: true, depth: true, preserveDrawingBuffer: true };
  const context = canvas.getContext("webgl2", wishes) as WebGL2RenderingContext | null;
  if (!context) throw new Error("no WebGL");
  const renderer = new WebGLRenderer({ canvas, context, ...wishes });
  renderer.setClearColor(0x000000, 0);
  renderer.domElement.addEventListener("webglcontextlost", onLost);
  const scene = new Scene();
  const eye = new OrthographicCamera();
  eye.matrixAutoUpdate = false;

  const colours = new DataTexture(new Uint8Array(1024), 256, 1);
  colours.minFilter = colours.magFilter = LinearFilter;
  const uniforms = {
    pixels: { value: 1 },
    radius: { value: 0 },
    shade: { value: 0 },
    reach: { value: 0 },
    walls: { value: [0, 0, 0, 0] },
    limits: { value: [0, 1] },
    cutLow: { value: new Vector3() },
    cutHigh: { value: new Vector3() },
    colours: { value: colours },
  };
  const material = new ShaderMaterial({ uniforms, vertexShader, fragmentShader });
  let geometry = new BufferGeometry();
  const slices: Points[] = [];
  const everywhere = new Sphere(new Vector3(), 1e9);

  const edges = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ transparent: true, opacity: 0.3 }));
  edges.frustumCulled = false;
  edges.renderOrder = 1;
  scene.add(edges);
  let drawnEdges: Float32Array | null = null;

  /** Uploads an array; the buffer on the device is kept while its size stays. */
  function setAttribute(name: string, array: Float32Array, itemSize: number): void {
    const old = geometry.getAttribute(name) as BufferAttribute | undefined;
    if (old && old.array.length === array.length && old.itemSize === itemSize) {
      if (old.array.byteOffset === array.byteOffset && old.array.buffer === array.buffer) return;
      old.array = array;
      old.needsUpdate = true;
      return;
    }
    geometry.setAttribute(name, new BufferAttribute(array, itemSize).setUsage(DynamicDrawUsage));
  }

  function setBody(body: Body): void {
    const old = geometry.getAttribute("position");
    if (old && old.count !== body.count) {
      geometry.dispose();
      geometry = new BufferGeometry();
      for (const slice of slices) slice.geometry = geometry;
    }
    setAttribute("position", body.positions, body.dimension);
    setAttribute("value", body.values, 1);
    while (slices.length < body.slices.length) {
      const slice = new Points(geometry, material);
      slice.frustumCulled = false;
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
    uniforms.limits.value = body.limits;
    uniforms.reach.value = body.size / 2;
    uniforms.walls.value = body.walls;
    uniforms.shade.value = body.shaded ? 1 : 0;
    uniforms.cutLow.value.fromArray(body.cut[0]);
    uniforms.cutHigh.value.fromArray(body.cut[1]);
    edges.visible = body.edges !== null;
    if (body.edges) (edges.material as LineBasicMaterial).color = new Color(body.edgeColour);
    if (body.edges && body.edges !== drawnEdges) {
      edges.geometry.dispose();
      edges.geometry = new BufferGeometry().setAttribute("position", new BufferAttribute(body.edges, 3));
      drawnEdges = body.edges;
    }
    // A section's mesh stands in front of the points, in space it runs through them.
    (edges.material as LineBasicMaterial).depthTest = body.shaded;
  }

  function setCamera(body: Body, camera: Camera): void {
    const { right, up, near } = camera.findAxes();
    const [cx, cy] = camera.centre;
    const reach = 2 * body.extent;
    eye.left = -cx / camera.scale;
    eye.right = (camera.width - cx) / camera.scale;
    eye.top = cy / camera.scale;
    eye.bottom = -(camera.height - cy) / camera.scale;
    eye.near = 0;
    eye.far = 2 * reach;
    eye.updateProjectionMatrix();
    const [r, u, n] = [right, up, near].map((v) => new Vector3(...v)) as [Vector3, Vector3, Vector3];
    eye.matrix = new Matrix4().makeBasis(r, u, n).setPosition(new Vector3(...camera.target).addScaledVector(n, reach));
    eye.matrixWorldNeedsUpdate = true;
    uniforms.pixels.value = Math.max(1.5, body.size * camera.scale * renderer.getPixelRatio());
    uniforms.radius.value = body.size / 2 / (2 * reach);
  }

  return {
    canvas: renderer.domElement,
    resize(width, height, density) {
      renderer.setPixelRatio(density);
      renderer.setSize(width, height);
    },
    draw(body, camera) {
      setBody(body);
      setCamera(body, camera);
      renderer.render(scene, eye);
    },
    dispose() {
      renderer.domElement.removeEventListener("webglcontextlost", onLost);
      geometry.dispose();
      edges.geometry.dispose();
      material.dispose();
      colours.dispose();
      renderer.dispose();
    },
  };
}
