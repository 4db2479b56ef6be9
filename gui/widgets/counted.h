// Numbers of things for people.
#pragma once

#include <QLocale>
#include <QString>
#include <cstddef>

namespace lodestone {

/// "1 contact", "1,085 contacts".
[[nodiscard]] inline QString counted(std::size_t number, const QString& one, const QString& many) {
  return QStringLiteral("%1 %2").arg(QLocale().toString(static_cast<qulonglong>(number)),
                                     number == 1 ? one : many);
}

}  // namespace lodestone
