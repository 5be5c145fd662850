(3: P0001 N001: G fehlt, richtig: G00..G91. Wort ergänzen.)
P0001
N001 J01#01#02#03
