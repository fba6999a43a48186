// SPDX-License-Identifier: MIT
/** Menu of the layers drawn besides and instead of the points. */
import { report, sequence } from "../state";
import { findComponents } from "./arrows";
import { Choice } from "./Choice";
import { listOtherSurfaces } from "./otherSurfaces";
import { arrowQuantity, arrowTitles, chosenSurfaces, layers, layerTitles, type ArrowQuantity, type LayerName } from "./settings";
import { findUsedWater } from "../drawing/standingWater";

function hasLayer(name: LayerName): boolean {
  const { model } = report.value;
  if (name === "water") return findUsedWater() !== undefined || (model.dimension === 2 && hasPressure());
  // Without a water table of each frame, the initial one is the water table.
  if (name === "startWater") return (findUsedWater()?.water_table.length ?? 0) > 0 && hasPressure();
  if (name === "hydraulics") return report.value.water?.conditions.some((c) => c.lines.length > 0) ?? false;
  if (name === "mesh") return model.mesh.cells !== undefined;
  const hasStrain = sequence.value?.fields.some((f) => f.name === "deviatoric_strain") ?? false;
  if (name === "ridge") return model.dimension === 2 && hasStrain;
  if (name === "otherSurfaces") return model.dimension === 2 && listOtherSurfaces().length > 0;
  if (name === "soils") return model.dimension === 2 && model.polygons.some((p) => p.material);
  if (name === "slip" || name === "present") return model.dimension === 2;
  if (name === "boundaries") return model.boundaries.some((b) => b.lines.length > 0);
  if (name === "monitors") return model.monitors.length > 0;
  return true;
}

const hasPressure = () => sequence.value?.fields.some((f) => f.name === "pore_pressure") ?? false;

/** Names of the layers in this model. */
function writeName(name: LayerName): string {
  if (report.value.model.dimension === 2) return layerTitles[name];
  return name === "mesh" ? "Surface of the background mesh" : name === "rulers" ? "Axes and box" : layerTitles[name];
}

export function LayerMenu() {
  const { dimension } = report.value.model;
  const quantities = (Object.keys(arrowTitles) as ArrowQuantity[]).filter(
    (name) => findComponents(sequence.value?.fields ?? [], name, dimension).length > 0,
  );
  return (
    <details class="viewer-menu">
      <summary>Layers</summary>
      <div class="viewer-form">
        {(Object.keys(layerTitles) as LayerName[]).filter(hasLayer).map((name) => (
          <label key={name}>
            <input
              type="checkbox"
              checked={layers.value[name]}
              onChange={(event) => (layers.value = { ...layers.value, [name]: event.currentTarget.checked })}
            />
            {writeName(name)}
          </label>
        ))}
        {layers.value.otherSurfaces && hasLayer("otherSurfaces") && (
          <fieldset class="viewer-surfaces">
            <legend>Surfaces</legend>
            {listOtherSurfaces().map((surface) => (
              <label key={surface.name}>
                <input
                  type="checkbox"
                  checked={surface.shown}
                  onChange={(event) =>
                    (chosenSurfaces.value = { ...chosenSurfaces.value, [surface.name]: event.currentTarget.checked })
                  }
                />
                {surface.text}
              </label>
            ))}
          </fieldset>
        )}
        {quantities.length > 0 && (
          <Choice
            label="Arrows"
            value={arrowQuantity.value}
            choose={(value) => (arrowQuantity.value = value as ArrowQuantity)}
            items={(["none", ...quantities] as const).map((name): [string, string] => [name, arrowTitles[name]])}
          />
        )}
      </div>
    </details>
  );
}
