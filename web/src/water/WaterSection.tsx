// SPDX-License-Identifier: MIT
/** The pore water that the stages began with, and the states before it: pressures, heads, saturation, flow. */
import { useState } from "preact/hooks";

import { Choice } from "../charts/base/Legend";
import { clipToSoil, drawOutlines, drawSoilNames, drawSoils } from "../drawing/ground";
import { GroundKeys, useOpacity } from "../drawing/Keys";
import { findSoilBox } from "../drawing/pen";
import { SectionCanvas } from "../drawing/SectionCanvas";
import { listQuantities, quantityTitles, useWaterLayer } from "./useWaterLayer";
import type { WaterQuantity } from "./waterFields";

export function WaterSection() {
  const [quantity, setQuantity] = useState<WaterQuantity>("pressure");
  const { opacity, slider } = useOpacity();
  const layer = useWaterLayer(quantity);
  const { state } = layer;
  return (
    <div class="chart-section">
      <div class="chart-bar no-print">
        <Choice
          label="Quantity of the pore water"
          value={quantity}
          options={listQuantities().map((value) => ({ value, title: quantityTitles[value] }))}
          onChange={setQuantity}
        />
        {layer.controls}
        {slider}
      </div>
      <SectionCanvas
        label={`Section with the ${quantityTitles[quantity]}: ${state?.title ?? ""}`}
        file={`water_${quantity}`}
        box={findSoilBox()}
        bar={layer.bar}
        draw={(pen) => {
          drawSoils(pen);
          clipToSoil(pen, () => layer.paint(pen, opacity));
          drawOutlines(pen);
          layer.drawOver(pen);
        }}
        depends={[...layer.depends, opacity]}
        drawOver={drawSoilNames}
        dependsOver={[]}
      />
      <ul class="drawing-keys" aria-label="Legend">
        <GroundKeys />
      </ul>
      {state && (
        <p class="chart-note">
          Shown: {state.title}. {layer.note}
        </p>
      )}
    </div>
  );
}
