/** The charts of the page. */
import "./charts.css";

export { CompareSection } from "./CompareSection";
export { CurveSection } from "./CurveSection";
export { HistorySection } from "./HistorySection";
export { ProfileSection } from "./ProfileSection";
export { SoilWaterSection } from "./SoilWaterSection";
export { StudySection } from "./StudySection";
