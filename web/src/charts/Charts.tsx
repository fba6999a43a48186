/** The charts of the page. */
import "./charts.css";

export { CalibrationSection } from "./CalibrationSection";
export { CompareSection } from "./CompareSection";
export { CurveSection } from "./CurveSection";
export { HistorySection } from "./HistorySection";
export { PointSection } from "./PointSection";
export { ProfileSection } from "./ProfileSection";
export { SoilWaterSection } from "./SoilWaterSection";
export { StudySection } from "./StudySection";
