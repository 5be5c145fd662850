(3: P0001 N001: F - ist so nicht lesbar, richtig: 0001..9999. Text berichtigen.)
P0001
N001 G11 F-100
