# SPDX-License-Identifier: GPL-3.0-or-later
class Overroll < Formula
  desc "Transient rough-surface elastohydrodynamic lubrication of line contacts"
  homepage "https://doi.org/10.1115/1.2920277"
  url "file:///path/to/overroll-0.4.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "GPL-3.0-or-later"

  depends_on "pkgconf" => :build
  depends_on "expat"
  depends_on "fftw"
  depends_on "gnuplot"
  depends_on "gsl"
  depends_on "hdf5"
  depends_on "libdeflate"
  depends_on "nettle"
  depends_on "zlib"

  def install
    system "make", "install", "PREFIX=#{prefix}"
  end

  test do
    assert_match "central film", shell_output("#{bin}/overroll steady --M 20 --L 10")
  end
end
