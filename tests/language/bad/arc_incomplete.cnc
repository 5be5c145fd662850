(4: P0001 N002: K fehlt. Wort ergänzen.)
P0001
N001 G18
N002 G02 X+1 Z+2 I+3
