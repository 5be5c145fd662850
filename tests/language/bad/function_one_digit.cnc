(3: P0001 N001: G ist so nicht lesbar, richtig: G00..G91. Text berichtigen.)
P0001
N001 G1 X+1000
