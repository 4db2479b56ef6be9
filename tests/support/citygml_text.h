// CityGML written by hand, a few elements at a time, and read from memory.
#pragma once

#include <string>
#include <vector>

#include <cpl_vsi.h>

#include "model/io/citygml/citygml.h"

namespace lodestone::test {

inline constexpr const char* kHead2 =
    "<c:CityModel xmlns:c='http://www.opengis.net/citygml/2.0' "
    "xmlns:b='http://www.opengis.net/citygml/building/2.0' "
    "xmlns:g='http://www.opengis.net/gml' xmlns:x='http://www.w3.org/1999/xlink' "
    "xmlns:gen='http://www.opengis.net/citygml/generics/2.0' "
    "xmlns:a='http://www.opengis.net/citygml/appearance/2.0' "
    "xmlns:f='http://www.opengis.net/citygml/cityfurniture/2.0' "
    "xmlns:grp='http://www.opengis.net/citygml/cityobjectgroup/2.0' "
    "xmlns:ade='http://example.org/ade'>";
inline constexpr const char* kHead3 =
    "<CityModel xmlns='http://www.opengis.net/citygml/3.0' "
    "xmlns:b='http://www.opengis.net/citygml/building/3.0' "
    "xmlns:con='http://www.opengis.net/citygml/construction/3.0' xmlns:g='http://www.opengis.net/gml/3.2' "
    "xmlns:gen='http://www.opengis.net/citygml/generics/3.0' "
    "xmlns:a='http://www.opengis.net/citygml/appearance/3.0' "
    "xmlns:x='http://www.w3.org/1999/xlink'>";

/// Reads text as a file of GDAL's memory.
inline Result<CityModel> readText(const std::string& text, const ImportOptions& options = {}) {
  const char* name = "/vsimem/citygml_test.gml";
  auto* bytes = reinterpret_cast<GByte*>(const_cast<char*>(text.data()));
  VSIFCloseL(VSIFileFromMemBuffer(name, bytes, text.size(), FALSE));
  auto result = cityGmlFormat().read(name, options, {});
  VSIUnlink(name);
  return result;
}

inline Result<CityModel> read2(const std::string& members) {
  return readText(kHead2 + members + "</c:CityModel>");
}
inline Result<CityModel> read3(const std::string& members) {
  return readText(kHead3 + members + "</CityModel>");
}

inline std::string building(const std::string& content, const std::string& id = "b1") {
  return "<c:cityObjectMember><b:Building g:id='" + id + "'>" + content +
         "</b:Building></c:cityObjectMember>";
}

inline std::string ring(const std::string& numbers, const std::string& id = {}) {
  return "<g:LinearRing" + (id.empty() ? "" : " g:id='" + id + "'") + "><g:posList>" + numbers +
         "</g:posList></g:LinearRing>";
}

inline constexpr const char* kSquare = "0 0 0 1 0 0 1 1 0 0 1 0 0 0 0";

inline std::string polygon(const std::string& id = {}, const std::string& numbers = kSquare) {
  return "<g:Polygon" + (id.empty() ? "" : " g:id='" + id + "'") + "><g:exterior>" +
         ring(numbers, id.empty() ? "" : id + "_r") + "</g:exterior></g:Polygon>";
}

inline std::string multi(const std::string& lod, const std::string& members) {
  return "<b:lod" + lod + "MultiSurface><g:MultiSurface>" + members + "</g:MultiSurface></b:lod" + lod +
         "MultiSurface>";
}

inline std::string member(const std::string& surface) {
  return "<g:surfaceMember>" + surface + "</g:surfaceMember>";
}
inline std::string link(const std::string& id) {
  return "<g:surfaceMember x:href='#" + id + "'/>";
}

inline std::string solid(const std::string& lod, const std::string& members) {
  return "<b:lod" + lod + "Solid><g:Solid><g:exterior><g:CompositeSurface>" + members +
         "</g:CompositeSurface></g:exterior></g:Solid></b:lod" + lod + "Solid>";
}

inline std::string boundary(const std::string& type, const std::string& content) {
  return "<b:boundedBy><b:" + type + ">" + content + "</b:" + type + "></b:boundedBy>";
}

inline std::vector<Code> codesOf(const Diagnostics& diagnostics) {
  std::vector<Code> codes;
  for (const Diagnostic& d : diagnostics) codes.push_back(d.code);
  return codes;
}

inline const CityObject& only(const Result<CityModel>& result) {
  return result->buildings.at(0).object;
}

inline std::vector<Vec3> ringOf(const Geometry& g, std::size_t r) {
  std::vector<Vec3> points;
  for (std::uint32_t i = g.ringStart[r]; i < g.ringStart[r + 1]; ++i)
    points.push_back(g.vertices[g.ringVertices[i]]);
  return points;
}

}  // namespace lodestone::test
