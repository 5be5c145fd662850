(3: P0000: Satznummer T 100 geht nicht, richtig: T001..T099. Andere Nummer wählen.)
P0000
T100 R+5000 L+0
