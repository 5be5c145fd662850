(3: P0001 N001: Wert fehlt. Wort ergänzen.)
P0001
N001 \00#01
N002 G17
