// SPDX-License-Identifier: MIT
#pragma once
// The XDMF 3 side-car of a series: ParaView before 5.12 cannot read a VTKHDF series, and reads this instead.
//
// ParaView has two XDMF readers, and they share no way to name a part of a dataset: one knows hyperslabs, the other a
// suffix of the path. So every part of a step gets a name of its own in the HDF5 file, as a virtual dataset under
// /xdmf: both readers open that, and no value is stored twice.

#include <string>

#include "output/files/vtkhdf.hpp"

namespace talus::output {

/// Writes the virtual datasets into the finished file of the series. Throws hdf5::Failure.
void write_views(hid_t file, const Series& series);

/// The XML text of a temporal collection over `series`, whose arrays stand in the HDF5 file `heavy_file` (a name
/// without folder, since the two files lie side by side). Steps without points are left out: XDMF cannot say "none".
std::string describe_series(const Series& series, const std::string& heavy_file, const std::string& name);

}  // namespace talus::output
