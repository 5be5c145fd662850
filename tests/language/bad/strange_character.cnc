(3: P0001 N001: * ist so nicht lesbar. Text berichtigen.)
P0001
N001 G01 X+1 * M03
