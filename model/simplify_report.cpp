#include "model/simplify_report.h"

#include <algorithm>

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
