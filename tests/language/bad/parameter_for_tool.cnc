(3: P0001 N001: T # passt nicht in diesen Satz. Wort entfernen.)
P0001
N001 G11 T#01
