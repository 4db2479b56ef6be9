// How well the eye tells a grating from a plain surface (Mannos and Sakrison 1974; Du, Zhu and Zhao, eq. 1).
#pragma once

namespace lodestone {

/// A(f) = 2.6 (0.0192 + c f) exp(−(c f)^1.1), of a frequency in cycles per degree. \pre frequency ≥ 0
[[nodiscard]] double contrastSensitivity(double frequency, double c);

/// The frequency at which A is largest, cycles per degree. \pre c > 0
[[nodiscard]] double peakFrequency(double c);

/// In the middle of a band of a wavelet transform (level 1: the finest), cycles per degree:
/// 0.75 · pixelsPerDegree / 2^level, and √2 more where it is high both across and down.
[[nodiscard]] double bandFrequency(int level, bool diagonal, double pixelsPerDegree);

/// What the eye lets through of a band: A over its largest value, 1 for frequencies up to the peak.
[[nodiscard]] double bandWeight(int level, bool diagonal, double pixelsPerDegree, double c);

}  // namespace lodestone
