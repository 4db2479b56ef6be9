#include "model/simplify_report.h"

#include <algorithm>
#include <numeric>

namespace lodestone {

const char* toString(ContactFate fate) {
  switch (fate) {
    case ContactFate::Kept:
      return "kept";
    case ContactFate::Separated:
      return "separated";
    case ContactFate::Lost:
      return "lost";
  }
  return "";
}

std::uint32_t StageReport::latent() const {
  return std::accumulate(classes.begin() + 1, classes.end(), 0U);
}

StageReport StageReport::operator+(const StageReport& other) const {
  StageReport sum = other;
  for (std::size_t c = 0; c < kDetailClasses; ++c) sum.classes[c] += classes[c];
  sum.unseen += unseen;
  sum.admitted += admitted;
  sum.removed += removed;
  return sum;
}

std::uint32_t SimplifyReport::count(ContactFate fate) const {
  return static_cast<std::uint32_t>(std::count_if(
      contacts.begin(), contacts.end(), [&](const ContactReport& contact) { return contact.fate == fate; }));
}

double SimplifyReport::widestGap() const {
  double widest = 0;
  for (const ContactReport& contact : contacts) widest = std::max(widest, contact.gap);
  return widest;
}

}  // namespace lodestone
