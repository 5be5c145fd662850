(3: P0001 N001: N ist so nicht lesbar, richtig: 001..999. Text berichtigen.)
P0001
N001 \53 N5
