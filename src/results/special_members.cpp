// SPDX-License-Identifier: MIT
// Special members of the largest result structs, defined here so that each is compiled only once.
#include "results/run.hpp"

#include "results/laboratory.hpp"
#include "results/study.hpp"

namespace talus::results {

RunResult::RunResult() = default;
RunResult::RunResult(const RunResult&) = default;
RunResult::RunResult(RunResult&&) noexcept = default;
RunResult& RunResult::operator=(const RunResult&) = default;
RunResult& RunResult::operator=(RunResult&&) noexcept = default;
RunResult::~RunResult() = default;

SliceResult::SliceResult() = default;
SliceResult::SliceResult(const SliceResult&) = default;
SliceResult::SliceResult(SliceResult&&) noexcept = default;
SliceResult& SliceResult::operator=(const SliceResult&) = default;
SliceResult& SliceResult::operator=(SliceResult&&) noexcept = default;
SliceResult::~SliceResult() = default;

MethodComparison::MethodComparison() = default;
MethodComparison::MethodComparison(const MethodComparison&) = default;
MethodComparison::MethodComparison(MethodComparison&&) noexcept = default;
MethodComparison& MethodComparison::operator=(const MethodComparison&) = default;
MethodComparison& MethodComparison::operator=(MethodComparison&&) noexcept = default;
MethodComparison::~MethodComparison() = default;

Sampling::Sampling() = default;
Sampling::Sampling(const Sampling&) = default;
Sampling::Sampling(Sampling&&) noexcept = default;
Sampling& Sampling::operator=(const Sampling&) = default;
Sampling& Sampling::operator=(Sampling&&) noexcept = default;
Sampling::~Sampling() = default;

StudyResult::StudyResult() = default;
StudyResult::StudyResult(const StudyResult&) = default;
StudyResult::StudyResult(StudyResult&&) noexcept = default;
StudyResult& StudyResult::operator=(const StudyResult&) = default;
StudyResult& StudyResult::operator=(StudyResult&&) noexcept = default;
StudyResult::~StudyResult() = default;

PointTests::PointTests() = default;
PointTests::PointTests(const PointTests&) = default;
PointTests::PointTests(PointTests&&) noexcept = default;
PointTests& PointTests::operator=(const PointTests&) = default;
PointTests& PointTests::operator=(PointTests&&) noexcept = default;
PointTests::~PointTests() = default;

}  // namespace talus::results
