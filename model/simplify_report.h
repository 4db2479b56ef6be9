// What simplification did to a model (resources/docs/methods.md, 2.4 and 5.4).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/geometry.h"
#include "model/perception.h"

namespace lodestone {

/// What became of a pair of components that touched.
enum class ContactFate : std::uint8_t { Kept, Separated, Lost };
[[nodiscard]] const char* toString(ContactFate fate);

struct ContactReport {
  std::uint32_t first = 0;  ///< components of the original
  std::uint32_t second = 0;
  ContactFate fate = ContactFate::Kept;
  double gap = 0;          ///< metres between the two, where they are separated
  Vec3 at = Vec3::Zero();  ///< where they touched: the middle of the boundary edges' ends
};

/// One value of a that was tried (resources/docs/methods.md, 2.6). Of several groups of touching buildings:
/// the worst gap and distance, the sum of the counts and of the scores.
struct AutoTrial {
  double a = 0;
  double widestGap = 0;  ///< metres
  double hausdorff = 0;  ///< metres
  std::uint32_t separated = 0;
  std::uint32_t lost = 0;
  double score = 0;          ///< (widest gap + Hausdorff distance) / diagonal
  std::uint32_t groups = 0;  ///< that are best with this a
};

/// Triangles by what pictures say of them, and what was removed (Du, Zhu and Zhao, table 2).
struct StageReport {
  std::array<std::uint32_t, kDetailClasses> classes{};  ///< of those that are seen, by class
  std::uint32_t unseen = 0;
  std::uint32_t admitted = 0;  ///< might be touched
  std::uint32_t removed = 0;   ///< all of them admitted

  /// Slight or above, those that any stage might touch: the paper's "latency" triangles.
  [[nodiscard]] std::uint32_t latent() const;
  [[nodiscard]] StageReport operator+(const StageReport& other) const;
};

struct SimplifyReport {
  std::uint32_t trianglesBefore = 0;
  std::uint32_t trianglesAfter = 0;
  std::uint32_t verticesBefore = 0;
  std::uint32_t verticesAfter = 0;
  std::uint32_t componentsBefore = 0;
  std::uint32_t componentsAfter = 0;
  std::uint32_t boundaryVertices = 0;
  std::uint32_t holeVertices = 0;
  std::vector<ContactReport> contacts;  ///< in the order of Classification::contacts
  double hausdorff = 0;                 ///< metres, the greater of both ways
  double a = 0;                         ///< that was used; of several groups, by most of them
  std::vector<AutoTrial> trials;        ///< of the search for a, by a; empty where it was given
  std::optional<StageReport> stage;     ///< of methods that ask pictures

  [[nodiscard]] std::uint32_t count(ContactFate fate) const;
  /// Of separated contacts; 0 where there are none.
  [[nodiscard]] double widestGap() const;
};

}  // namespace lodestone
