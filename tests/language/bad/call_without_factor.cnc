(3: P0001 N001: W fehlt. Wort ergänzen.)
P0001
N001 G22 P0002 N001
