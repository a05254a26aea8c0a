# SPDX-License-Identifier: GPL-3.0-or-later
# Draws any chart of overroll.  What is drawn stands before this text, as
# variables, arrays and the tables of `data`: overroll-pictures(7) lists them.
# Panels are placed by hand, in letter heights, so that legends, labels and
# numbers have the room they need at any size of the picture; legends, notes
# and titles stand above the panels, where no curve is.
# A template may set these before it has this one drawn:
if (!exists('font')) font = form eq 'svg' ? 'Helvetica,Arial,sans-serif' : 'Sans'
# blue amber steel red green violet grey white ink: lines, and areas below them
if (!exists('line_colours')) line_colours = '#1d5fa8 #c96a00 #4a5560 #b3202a \
  #2a7f4f #6b4ba1 #8a929a #ffffff #101418'
if (!exists('area_colours')) area_colours = '#dce8f5 #fbe3bd #b9c2ca #f6dcdd \
  #d8eee1 #e7e0f2 #e6e9ec #ffffff #101418'
if (!exists('letter')) letter = 20 * (width > 794 ? width / 1280. : 0.62)

# --------------------------------------------------------------------- style
scale = letter / 20.
# gnuplot may have been built without cairo
has(name) = strstrt(' ' . GPVAL_TERMINALS . ' ', ' ' . name . ' ') > 0
if (form eq 'png' && !has('pngcairo')) {
  face = sprintf('%s,%.4g', font, 10 * scale) # no expression may stand there
  set terminal png size width,height enhanced font face linewidth scale \
    background '#ffffff'
}
if (form eq 'pdf' && !has('pdfcairo')) {
  exit error 'this gnuplot has no pdfcairo terminal: write an .svg or .png picture'
}
if (form eq 'png' && has('pngcairo')) {
  set terminal pngcairo size width,height enhanced \
    font sprintf('%s,%.4g', font, 13 * scale) linewidth scale \
    background '#ffffff'
}
if (form eq 'svg') {
  set terminal svg size width,height dynamic enhanced \
    font sprintf('%s,%.4g', font, 17 * scale) linewidth scale \
    background '#ffffff'
}
if (form eq 'pdf') {
  set terminal pdfcairo size width / 160.,height / 160. enhanced \
    font sprintf('%s,%.4g', font, 9 * scale) linewidth 0.6 * scale \
    background '#ffffff'
}
set encoding utf8
set datafile nofpe_trap
set clip one
set clip two
set border 3 lw 1 lc rgb '#606870'
set tics out nomirror scale 0.6 textcolor rgb '#303840'
set minussign
unset key
unset colorbox
unset title
set palette defined (0 '#1b1044', 0.2 '#3b3a8c', 0.4 '#2a7a98', \
  0.6 '#45a882', 0.8 '#c9cf52', 1 '#fff3b0')
text = '#202830'
line(k) = word(line_colours, colour[k])
area(k) = word(area_colours, colour[k])

# -------------------------------------------------------------------- layout
# Margins of the picture and room for the colours of an image, letter heights;
# how wide a letter is.
left = 5.6
right = 1.2
bottom = 3.4
scale_room = 7.2
wide = 0.53
em = 1. * letter / width
em_y = 1. * letter / height
letters_across = (1. * width / letter - left - right) / wide

images = 0
do for [p=1:rows * columns] { images = images + (image[p] >= 0) }
gap = share_x ? 0.5 : bottom
gap_x = !share_y ? left + 0.4 : share_x ? 1 : 2.4
column_width = (1 - (left + right) * em - (columns - 1) * gap_x * em) / columns \
  - (images ? scale_room * em : 0)

# The title, then the note of each panel, broken at blanks into lines that fit.
array said[1 + rows * columns]
array lines[1 + rows * columns]
do for [t=1:1 + rows * columns] {
  whole = t == 1 ? title : note[t - 1]
  room = int(t == 1 ? letters_across : column_width / em / wide)
  said[t] = ''
  lines[t] = strlen(whole) > 0
  begin = 1
  blank = 0
  do for [k=1:strlen(whole) > room ? strlen(whole) : 0] {
    if (whole[k:k] eq ' ') { blank = k }
    if (k - begin >= room) {
      if (blank < begin) { blank = k - 1 }
      said[t] = said[t].whole[begin:blank]."\n"
      begin = blank + 1
      lines[t] = lines[t] + 1
    }
  }
  said[t] = said[t].whole[begin:*]
}

# The subtitle stands behind the title or, where that leaves no room, below.
shown = strlen(subtitle)
do for [k=1:strlen(subtitle)] {
  if (subtitle[k:k + 8] eq '{/:Italic') { shown = shown - 11 }
}
below = lines[1] && shown && (lines[1] > 1 || \
  strlen(title) + shown + 3 > letters_across)
head_lines = lines[1] + (below || !lines[1] && shown)
head = head_lines ? 0.6 + 1.3 * head_lines : 0.3

# Legends: one for each row of panels, of its first panel, over the whole width
# in as many lines as it takes.
curves = last[rows * columns]
array legend_x[curves + 1]
array legend_line[curves + 1]
array legends[rows]
array above[rows]
array row_top[rows]
array row_height[rows]
above_all = 0
sum = 0
do for [r=1:rows] {
  f = (r - 1) * columns + 1
  legends[r] = 0
  used = 0
  do for [k=first[f]:last[f]] {
    if (strlen(label[k])) {
      entry = 3.2 + wide * (strlen(label[k]) < 60 ? strlen(label[k]) : 60)
      if (!legends[r] || used + entry > letters_across * wide) {
        used = 0
        legends[r] = legends[r] + 1
      }
      legend_x[k] = used
      legend_line[k] = legends[r]
      used = used + entry
    }
  }
  above[r] = 0
  do for [p=f:f + columns - 1] {
    if (lines[p + 1] > above[r]) { above[r] = lines[p + 1] }
  }
  above[r] = 1.25 * above[r] + (legends[r] ? 0.4 + 1.3 * legends[r] : 0.3)
  do for [p=f:f + columns - 1] { # a mark above its colours
    if (beyond[p] && above[r] < 1.5) { above[r] = 1.5 }
  }
  above_all = above_all + above[r]
  sum = sum + tall[f]
}
# Below a drawing stand numbers of its own.
array gaps[rows]
gaps_all = 0
do for [r=1:rows] {
  gaps[r] = r == rows ? 0 : equal[(r - 1) * columns + 1] ? bottom : gap
  gaps_all = gaps_all + gaps[r]
}
high = 1 - (head + bottom + above_all + gaps_all) * em_y
top = 1 - head * em_y
do for [r=1:rows] {
  row_top[r] = top - above[r] * em_y
  row_height[r] = high * tall[(r - 1) * columns + 1] / sum
  top = row_top[r] - row_height[r] - gaps[r] * em_y
}

# ------------------------------------------------------------- axes and tics
empty(p) = last[p] < first[p] && image[p] < 0
limit(v) = v == v ? sprintf('%.9g', v) : '*'
# 1, 2 or 5 times a power of ten, at most `most` of them in a span
nice(span, most) = (size_ = 10 ** floor(log10(span / most)), \
  digit_ = span / most / size_, \
  size_ * (digit_ <= 1 ? 1 : digit_ <= 2 ? 2 : digit_ <= 5 ? 5 : 10))

# -------------------------------------------------------------------- panels
set multiplot
do for [r=1:rows] {
do for [c=1:columns] {
  p = (r - 1) * columns + c
  if (empty(p)) { continue }
  x0 = left * em + (c - 1) * (column_width + \
    (gap_x + (images ? scale_room : 0)) * em)
  x1 = x0 + column_width
  y1 = row_top[r]
  y0 = y1 - row_height[r]
  across = (x1 - x0) / em
  up = (y1 - y0) / em_y
  low = !share_x || r == rows || equal[p]
  if (r < rows) { low = low || empty(p + columns) }
  outer = !share_y || c == 1
  unset label
  unset arrow

  # lines of equal value at every other cell, made before the axes are set
  if (strlen(bold_contours[p])) {
    dx = (x_to[p] - x_from[p]) / cells_x[p]
    dy = (y_to[p] - y_from[p]) / cells_y[p]
    set autoscale
    unset logscale
    set format '%.7g'
    set contour base
    unset surface
    levels = ''
    do for [v in contours[p].' '.bold_contours[p]] { levels = levels.', '.v }
    eval 'set cntrparam levels discrete '.levels[3:*]
    set table $equal
    splot data index image[p] matrix every 2:2 using \
      (x_from[p] + dx / 2 + dx * $1):(y_from[p] + dy / 2 + dy * $2):3
    unset table
    unset contour
  }

  if (image[p] >= 0) {
    image_x = x_from[p]
    image_y = y_from[p]
    image_dx = (x_to[p] - x_from[p]) / cells_x[p]
    image_dy = (y_to[p] - y_from[p]) / cells_y[p]
  }

  # a drawing: the axis that is too short for its panel grows
  if (equal[p]) {
    unit_x = (x_to[p] - x_from[p]) / ((x1 - x0) * width)
    unit_y = (y_to[p] - y_from[p]) / ((y1 - y0) * height)
    if (unit_x > unit_y) {
      more = (unit_x - unit_y) * (y1 - y0) * height / 2
      y_from[p] = y_from[p] - more
      y_to[p] = y_to[p] + more
    } else {
      more = (unit_y - unit_x) * (x1 - x0) * width / 2
      x_from[p] = x_from[p] - more
      x_to[p] = x_to[p] + more
    }
  }

  set lmargin at screen x0
  set rmargin at screen x1
  set bmargin at screen y0
  set tmargin at screen y1
  eval sprintf('set xrange [%s:%s]', limit(x_from[p]), limit(x_to[p]))
  eval sprintf('set yrange [%s:%s]', limit(y_from[p]), limit(y_to[p]))
  unset logscale
  if (log_x[p]) { set logscale x }
  if (log_y[p]) { set logscale y }
  set xtics autofreq offset 0,(form eq 'svg' ? 0.4 : 0)
  set ytics autofreq
  if (low) { set format x '%g' } else { set format x '' }
  if (outer) { set format y '%g' } else { set format y '' }
  if (x_to[p] > x_from[p] && !log_x[p]) {
    set xtics nice(x_to[p] - x_from[p], across < 32.4 ? across / 3.6 : 9)
  }
  middle = (y0 + y1) / 2
  if (ground[p]) {
    # a line at zero, numbers above it alone; below it, where anything is, a
    # bar of round length in their place
    span = y_to[p] - y_from[p]
    most = up * y_to[p] / span / 1.6
    set ytics 0,nice(y_to[p], most < 10 ? most : 10)
    set arrow from graph 0,first 0 to graph 1,first 0 nohead lw 1 \
      lc rgb '#606870' front
    middle = (y0 - (y1 - y0) * y_from[p] / span + y1) / 2
    if (c == 1 && y_from[p] < 0 && -up * y_from[p] / span >= 1.5) {
      bar = nice(-0.6 * y_from[p], 1.2)
      foot = y0 + 0.3 * em_y
      tip = foot + (y1 - y0) * bar / span
      set arrow from screen x0 - 0.6 * em,foot to screen x0 - 0.6 * em,tip \
        heads size screen 0.003,90 lw 1.5 lc rgb text front
      set label sprintf('%g %s', bar, unit[p]) noenhanced \
        at screen x0 - 1.1 * em,(foot + tip) / 2 right front \
        textcolor rgb text
    }
  } else {
    if (y_to[p] > y_from[p] && !log_y[p]) {
      set ytics nice(y_to[p] - y_from[p], up < 16 ? up / 1.6 : 10)
    }
  }
  if (low) {
    set label x_label[p] at screen (x0 + x1) / 2,y0 - 2.4 * em_y center
  }
  if (outer) {
    set label y_label[p] at screen x0 - 5 * em,middle center rotate
  }

  # title, legend, note
  if (p == 1) {
    set label said[1] noenhanced at screen x0,1 - em_y left textcolor rgb text
    if (below || !lines[1]) {
      set label subtitle at screen x0,1 - (0.3 + 1.3 * head_lines - 0.6) * em_y \
        left textcolor rgb text
    } else {
      set label subtitle at screen 1 - right * em,1 - em_y right \
        textcolor rgb text
    }
  }
  if (c == 1) {
    do for [k=first[p]:last[p]] {
      if (strlen(label[k])) {
        x = x0 + (0.3 + legend_x[k]) * em
        y = y1 + (above[r] - 1.3 * legend_line[k] + 0.35) * em_y
        dash = mark[k] eq 'dashed' ? "'-'" : mark[k] eq 'dotted' ? "'.'" : 'solid'
        eval sprintf("set arrow from screen %.5f,%.5f to screen %.5f,%.5f \
          nohead dt %s lw %.3g lc rgb '%s'", \
          x, y, x + 1.5 * em, y, dash, mark[k] eq 'band' ? 9 : weight[k] + 0.5, \
          mark[k] eq 'band' ? area(k) : line(k))
        set label label[k] noenhanced at screen x + 1.9 * em,y left \
          textcolor rgb text
      }
    }
  }
  if (lines[p + 1]) {
    set label said[p + 1] noenhanced \
      at screen x0 + 0.3 * em,y1 + (1.25 * lines[p + 1] - 0.55) * em_y left \
      textcolor rgb text
  }

  # what is plotted, as one command
  command = ''
  set grid xtics ytics lt 1 lw 0.6 lc rgb '#e4e8ec'
  if (image[p] >= 0) {
    unset grid
    set cbrange [colour_from[p]:colour_to[p]]
    set format cb '%g'
    set cblabel colour_label[p] offset character 1.2,0
    set colorbox user origin screen x1 + em,y0 size screen 1.2 * em,y1 - y0
    if (beyond[p]) {
      set label '▲ above' at screen x1 + 1.6 * em,y1 + 0.8 * em_y center \
        textcolor rgb text
    }
    command = sprintf(', data index %d matrix using \
      (%.9g+%.9g*$1):(%.9g+%.9g*$2):3 with image', \
      image[p], image_x + image_dx / 2, image_dx, \
      image_y + image_dy / 2, image_dy)
    if (strlen(bold_contours[p])) {
      bold(v) = sum [k=1:words(bold_contours[p])] \
        (abs(v / word(bold_contours[p], k) - 1) < 1e-6)
      command = command.", $equal with lines lw 0.7 lc rgb '#ffffff', \
        $equal using 1:(bold($3) ? $2 : NaN) with lines lw 1.5 \
        lc rgb '#101418'"
    }
  }
  do for [k=first[p]:last[p]] {
    part = sprintf(', data index %d using 1:2', k - 1)
    ink = sprintf(" lw %.3g lc rgb '%s'", weight[k], line(k))
    if (mark[k] eq 'area') {
      command = command.part.sprintf(" with filledcurves y=%.9g \
        fillstyle solid fillcolor rgb '%s'", base[k], area(k))
    }
    command = command.part.( \
      mark[k] eq 'band' ? sprintf(":3 with filledcurves fillstyle solid \
        fillcolor rgb '%s'", area(k)) : \
      mark[k] eq 'points' ? sprintf(" with points pt 7 ps %.3g lc rgb '%s'", \
        weight[k] / 3, line(k)) : \
      mark[k] eq 'cross' ? ' with points pt 2 ps 1.6'.ink : \
      mark[k] eq 'dashed' ? " with lines dt '-'".ink : \
      mark[k] eq 'dotted' ? " with lines dt '.'".ink : ' with lines'.ink)
    if (strlen(letters[k])) {
      command = command.sprintf(", data index %d using \
        1:2:(word(letters[%d], int($0) + 1)) with labels noenhanced \
        offset 0.9,0.7 textcolor rgb '%s'", k - 1, k, line(k))
    }
  }
  if (strlen(command)) { eval 'plot '.command[3:*] }
}
}
unset multiplot
