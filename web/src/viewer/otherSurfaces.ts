// SPDX-License-Identifier: MIT
/** Slip surfaces that LEM and FEM found, to be laid over the points. */
import { listSurfaces, type NamedSurface } from "../compared/surfaces";
import { chosenSurfaces } from "./settings";

export type OtherSurface = NamedSurface & { shown: boolean };

/** Slip surfaces of other methods; those of MPM are drawn by the viewer itself. */
export function listOtherSurfaces(): OtherSurface[] {
  return listSurfaces()
    .filter((surface) => surface.method !== "mpm")
    .map((surface) => ({ ...surface, shown: chosenSurfaces.value[surface.name] ?? surface.first }));
}
