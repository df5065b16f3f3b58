// The whole of `clog export`: what a run or a flow file holds, for ParaView and OVITO.
#pragma once

#include <filesystem>

#include "coupling/files/flow_grid.hpp"
#include "coupling/files/run_file.hpp"

namespace clogflow::postprocess {

enum class ExportFormat { vtk, xyz };

/// For ParaView NAME.pvd and a folder NAME with a .vtp for each snapshot; for OVITO NAME.xyz; NAME is that of the run
/// file. A snapshot's file holds places, "radius [m]", "velocity [m/s]", "spin [rad/s]", "force [N]", "torque [N m]",
/// id, and species where particles differ. Of a run that recorded contacts NAME_contacts.pvd too: a line for each, from
/// centre to centre or to the wall, with "normal force [N]", "force [N]" and the ids of its ends (a wall is -1).
///  The walls only widen the box of NAME.xyz.
/// \return the file to open  \throws Error without a snapshot, or when a file cannot be written
std::filesystem::path export_run(const RunData& run, const std::string& name, const Walls& walls, ExportFormat format,
                                 const std::filesystem::path& out);

/// walls.vtp. \throws Error likewise
std::filesystem::path export_walls(const Walls& walls, const std::filesystem::path& out);

/// NAME.hdf: the flow file under a name that ParaView opens (5.11 knows a VTKHDF file by this ending alone).
/// \throws Error likewise
std::filesystem::path export_flow(const FlowGrid& flow, const std::string& name, const std::filesystem::path& out);

/// show_in_paraview.py: a script or macro that opens everything in the folder, particles as spheres.
/// \throws Error likewise
std::filesystem::path export_macro(const std::filesystem::path& out);

}  // namespace clogflow::postprocess
