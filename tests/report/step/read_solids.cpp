// SPDX-License-Identifier: Apache-2.0
#include "tests/report/step/read_solids.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Wire.hxx>
#include <stdexcept>

#include "tests/io/scratch_folder.hpp"

namespace torquewright::test {
namespace {

constexpr int kPointsOnEdge = 24;

std::array<double, 6> box_of(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
  std::array<double, 6> sides{};
  box.Get(sides[0], sides[1], sides[2], sides[3], sides[4], sides[5]);
  return sides;
}

double volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  constexpr double kRelative = 1e-9;
  BRepGProp::VolumeProperties(shape, properties, kRelative);
  return properties.Mass();
}

std::vector<gearbox::Point> points_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
  std::vector<gearbox::Point> points;
  for (BRepTools_WireExplorer edges(wire, face); edges.More(); edges.Next()) {
    const BRepAdaptor_Curve curve(edges.Current());
    const bool is_forward = edges.Current().Orientation() == TopAbs_FORWARD;
    for (int i = 0; i < kPointsOnEdge; ++i) {
      const double share = static_cast<double>(i) / kPointsOnEdge;
      const double along = is_forward ? share : 1.0 - share;
      const gp_Pnt point = curve.Value(curve.FirstParameter() +
                                       along * (curve.LastParameter() - curve.FirstParameter()));
      points.push_back({point.X(), point.Y()});
    }
  }
  return points;
}

std::vector<std::vector<gearbox::Point>> bottom_of(const TopoDS_Shape& solid, double z_mm) {
  std::vector<std::vector<gearbox::Point>> boundaries;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
    const TopoDS_Face face = TopoDS::Face(faces.Current());
    const BRepAdaptor_Surface surface(face);
    if (surface.GetType() != GeomAbs_Plane || surface.Value(0.0, 0.0).Z() > z_mm + 1e-3) continue;
    const TopoDS_Wire outer = BRepTools::OuterWire(face);
    boundaries.push_back(points_of(outer, face));
    for (TopExp_Explorer wires(face, TopAbs_WIRE); wires.More(); wires.Next()) {
      const TopoDS_Wire wire = TopoDS::Wire(wires.Current());
      if (!wire.IsSame(outer)) boundaries.push_back(points_of(wire, face));
    }
  }
  return boundaries;
}

}  // namespace

std::vector<ReadSolid> read_solids(const std::string& text) {
  const ScratchFolder folder;
  const std::string file = folder.write("gears.step", text).string();
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error("not read");
  if (reader.TransferRoots() != 1) throw std::runtime_error("not one root");
  std::vector<ReadSolid> solids;
  for (TopExp_Explorer found(reader.OneShape(), TopAbs_SOLID); found.More(); found.Next()) {
    ReadSolid& solid = solids.emplace_back();
    solid.is_valid = BRepCheck_Analyzer(found.Current()).IsValid();
    solid.volume_mm3 = volume_of(found.Current());
    solid.box_mm = box_of(found.Current());
    solid.bottom = bottom_of(found.Current(), solid.box_mm[2]);
  }
  return solids;
}

}  // namespace torquewright::test
