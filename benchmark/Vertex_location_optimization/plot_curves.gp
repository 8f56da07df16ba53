# Draws curves over logarithmic axes, the first column of a CSV file against the others, and a panel for each file:
#
#   gnuplot -c plot_curves.gp PLOT.svg Y_LABEL VALUES.csv...
#
# A fourth curve is one to compare the others with.
panels = ARGC - 2
set terminal svg size 740 * panels, 400 noenhanced font "sans-serif,14" background "white"
set output ARG1
set datafile separator ","
set logscale xy
set grid linetype 1 linecolor "#dddddd" linewidth 1
set autoscale fix
set offsets graph 0.03, graph 0.03, graph 0.05, graph 0.05
set key outside right top Left reverse samplen 3 autotitle columnheader
set ylabel ARG2
set tics nomirror scale 0.5, 0

# Okabe and Ito's colors, which the color-blind tell apart
set linetype 1 linecolor "#d55e00" linewidth 2.5 pointtype 7
set linetype 2 linecolor "#0072b2" linewidth 2.5 pointtype 5
set linetype 3 linecolor "#009e73" linewidth 2.5 pointtype 9
set linetype 4 linecolor "#666666" linewidth 1.5 dashtype 2 pointtype 0

do for [power = -4 : 6] {
  do for [digit in "1 2 5"] {
    tick = digit * 10 ** power
    label = tick < 1000 ? sprintf("%g", tick) : gprintf("%.0s%c", tick)
    set xtics add (label tick)
    set ytics add (label tick)
  }
}

set multiplot layout 1, panels
do for [k = 3 : ARGC] {
  file = value(sprintf("ARG%d", k))
  set xlabel system(sprintf("head -n 1 '%s' | cut -d, -f1", file))
  stats file nooutput
  plot for [column = 2 : STATS_columns] file using 1:column linetype column - 1 with linespoints
}
unset multiplot
