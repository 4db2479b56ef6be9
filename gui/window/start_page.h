// The first thing people see: open, try the sample town, or go on where they were.
#pragma once

#include <QStringList>
#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace lodestone {

class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecent(const QStringList& paths);

 Q_SIGNALS:
  void openRequested();
  void sampleRequested();
  void recentChosen(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QVBoxLayout* recent_;
  QLabel* recentTitle_;
};

}  // namespace lodestone
