// SPDX-License-Identifier: MIT
/** The charts of the page. */
import "./charts.css";

export { CalibrationSection } from "./laboratory/CalibrationSection";
export { CompareSection } from "./compare/CompareSection";
export { CurveSection } from "./curve/CurveSection";
export { HistorySection } from "./history/HistorySection";
export { PointSection } from "./laboratory/PointSection";
export { ProfileSection } from "./profile/ProfileSection";
export { SoilWaterSection } from "./water/SoilWaterSection";
export { StudySection } from "./study/StudySection";
