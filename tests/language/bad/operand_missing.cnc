(3: P0001 N001: # fehlt. Wort ergänzen.)
P0001
N001 \01#01#02
