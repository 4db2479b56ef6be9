// The ways in which files spell a coordinate reference system.
#pragma once

#include <string>
#include <string_view>

namespace lodestone {

/// What a spelling says, before any database is asked.
struct CrsSpelling {
  enum class Kind {
    None,   ///< empty
    Local,  ///< "#local-CRS-1": an engineering CRS inside the file
    Epsg,   ///< codes
    Text,   ///< WKT, a PROJ string, a name: for PROJ to understand
  };
  Kind kind = Kind::None;
  int horizontal = 0;      ///< EPSG code, also of a compound CRS
  int vertical = 0;        ///< EPSG code of a second, vertical part; 0: none
  bool eastFirst = false;  ///< the spelling itself says longitude before latitude: "EPSG:N", "CRS84"
  std::string text;        ///< the spelling without blanks at its ends
};

/// Understands EPSG:N, EPSG:N+M, N, urn:ogc:def:crs:EPSG:[version]:N, urn:ogc:def:crs,crs:EPSG::N,crs:EPSG::M
/// (blanks and a missing "crs:" forgiven), http(s)://www.opengis.net/def/crs/EPSG/0/N,
/// …/crs-compound?1=…&2=…, OGC:CRS84 in the same forms, the AdV's names
/// urn:adv:crs:ETRS89_UTM32*DE_DHHN92_NH[*geoid], and names that are not PROJ's own ("CH1903"). Everything
/// else is text. Linear in the length; never throws on bad input.
[[nodiscard]] CrsSpelling parseCrs(std::string_view spelling);

}  // namespace lodestone
