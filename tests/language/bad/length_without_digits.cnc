(3: P0001 N001: X ist so nicht lesbar. Text berichtigen.)
P0001
N001 G00 X+ Y+1
