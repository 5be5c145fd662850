(3: P0001 N001: Y ist so nicht lesbar, richtig: 0.001. Text berichtigen.)
P0001
N001 G00 Y0.0005
