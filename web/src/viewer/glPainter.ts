// SPDX-License-Identifier: MIT
/** Draws the body with three.js: points as cells or spheres with true depth, coloured through a lookup table. */
import {
  BufferAttribute, BufferGeometry, Color, LineBasicMaterial, LineSegments, Matrix4, OrthographicCamera, Scene, Vector3,
  WebGLRenderer,
} from "three";

import type { Camera, Vec } from "./camera";
import { makeCoverMeshes } from "./glCover";
import { makePointMeshes } from "./glPoints";
import { toLocal, type Body, type Painter } from "./painter";

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
