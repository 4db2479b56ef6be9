// Names of files and objects as texts of menu items and buttons.
#pragma once

#include <QString>

namespace lodestone {

/// Menu items and buttons take a "&" for the mark of a shortcut key; a name may have one of its own.
[[nodiscard]] inline QString withoutMnemonic(QString name) {
  return name.replace(QLatin1Char('&'), QStringLiteral("&&"));
}

}  // namespace lodestone
