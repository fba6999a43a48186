// SPDX-License-Identifier: MIT
/** Profiles: a field over height along a vertical section, and the line of the ground before and after. */
import { report } from "../../state";
import { GroundChart } from "./GroundChart";
import { SectionCharts } from "../sections/SectionCharts";
import { VerticalSection } from "./VerticalSection";

export function ProfileSection() {
  const grounds = report.value.tables.filter((t) => t.kind === "ground");
  const named = (report.value.sections ?? []).length > 0;
  const sections = report.value.sequences.some((s) => s.frames.length > 0 && s.fields.length > 0);
  if (!named && !sections && grounds.length === 0) return null;
  return (
    <section class="chart-section" aria-labelledby="chart-profile-title">
      <h3 id="chart-profile-title">Profiles</h3>
      <SectionCharts />
      {sections && <VerticalSection />}
      {grounds.map((t) => (
        <GroundChart key={t.id} table={t} />
      ))}
    </section>
  );
}
