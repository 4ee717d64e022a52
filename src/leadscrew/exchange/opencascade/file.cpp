// Files read by OpenCASCADE, in mm.

#include <IGESControl_Reader.hxx>
#include <IGESData_GlobalSection.hxx>
#include <IGESData_IGESModel.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_SequenceOfAsciiString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <algorithm>
#include <cctype>

#include "opencascade.hpp"

namespace leadscrew::exchange {

namespace {

std::string shown_unit(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  if (name.starts_with("milli") || name == "mm") return "mm";
  if (name.starts_with("in")) return "inch";
  if (name.starts_with("centi") || name == "cm") return "cm";
  if (name == "metre" || name == "meter" || name == "m") return "m";
  if (name.starts_with("foot") || name == "ft") return "ft";
  return name;
}

template <class Reader>
TopoDS_Shape shape_of(Reader& reader, const std::string& file) {
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone)
    throw Unreadable("exchange-read", "cannot be read", "is the file whole? Export it anew, or in the other format");
  reader.TransferRoots();
  return reader.OneShape();
}

}  // namespace

Part part_of(const std::string& format, const std::string& file) {
  Part part;
  if (format == "STEP") {
    STEPControl_Reader reader;
    part.shape = shape_of(reader, file);
    TColStd_SequenceOfAsciiString lengths, angles, solid_angles;
    reader.FileUnits(lengths, angles, solid_angles);
    if (!lengths.IsEmpty()) part.unit = shown_unit(lengths.First().ToCString());
  } else {
    IGESControl_Reader reader;
    Interface_Static::SetIVal("read.iges.bspline.continuity", 0);  // leaves surfaces as they are
    part.shape = shape_of(reader, file);
    const auto model = Handle(IGESData_IGESModel)::DownCast(reader.Model());
    if (!model.IsNull() && !model->GlobalSection().UnitName().IsNull())
      part.unit = shown_unit(model->GlobalSection().UnitName()->ToCString());
  }
  return part;
}

}  // namespace leadscrew::exchange
