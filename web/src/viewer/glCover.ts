// SPDX-License-Identifier: MIT
/** Joins the cells of a section to one body: its triangles become opaque, the rest of the cells is removed. */
import {
  AddEquation, BufferAttribute, BufferGeometry, CustomBlending, DstAlphaFactor, DynamicDrawUsage, Mesh, OneFactor,
  ShaderMaterial, Sphere, Vector3, ZeroFactor, type BlendingDstFactor, type BlendingSrcFactor, type Scene,
} from "three";

import { toLocal, type Body } from "./painter";
import { plainFragments, plainVertices, screenVertices } from "./shaders";

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

export function makeCoverMeshes(scene: Scene) {
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
