(3: P0001 N001: H fehlt. Wort ergänzen.)
P0001
N001 G04
